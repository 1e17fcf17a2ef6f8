#include "experiments/mission/moving_things.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ariadne::experiments {
namespace {

using Eigen::Vector2d;

constexpr double kPlaceEvery = 0.12;  // between the places of a moving thing [s]
constexpr int kAround = 8;            // places around it

}  // namespace

/// Of the runs of points that are small, and nearer than what is seen beside them.
std::vector<Vector2d> MovingThings::MiddlesOf(std::span<const Vector2d> points_odom,
                                              const Vector2d& viewpoint_odom) const {
  const auto range = [&](std::size_t i) { return (points_odom[i] - viewpoint_odom).norm(); };
  std::vector<Vector2d> middles;
  for (std::size_t first = 0; first < points_odom.size();) {
    std::size_t end = first + 1;
    while (end < points_odom.size() && (points_odom[end] - points_odom[end - 1]).norm() < options_.gap)
      ++end;
    const bool small = (points_odom[end - 1] - points_odom[first]).norm() < options_.largest;
    const bool hidden = (first > 0 && range(first - 1) < range(first)) ||
                        (end < points_odom.size() && range(end) < range(end - 1));
    if (small && !hidden) {
      Vector2d sum = Vector2d::Zero();
      for (std::size_t i = first; i < end; ++i) sum += points_odom[i];
      middles.emplace_back(sum / static_cast<double>(end - first));
    }
    first = end;
  }
  return middles;
}

/// The slope of a line through its middles over time; zero where it has not been watched for long enough.
Vector2d MovingThings::VelocityOf(const Track& track) const {
  if (track.seen.back().time - track.seen.front().time < options_.least) return Vector2d::Zero();
  double mean_time = 0.0;
  Vector2d mean = Vector2d::Zero();
  for (const Seen& seen : track.seen) mean_time += seen.time, mean += seen.middle_odom;
  const auto count = static_cast<double>(track.seen.size());
  mean_time /= count, mean /= count;
  double spread = 0.0;
  Vector2d moment = Vector2d::Zero();
  for (const Seen& seen : track.seen) {
    spread += (seen.time - mean_time) * (seen.time - mean_time);
    moment += (seen.time - mean_time) * (seen.middle_odom - mean);
  }
  return moment / spread;
}

/// Whether it has gone far enough, evenly.
bool MovingThings::Walks(const Track& track) const {
  const Vector2d velocity = VelocityOf(track);
  const double span = track.seen.back().time - track.seen.front().time;
  if (velocity.norm() < options_.slowest || velocity.norm() * span < options_.way) return false;
  Vector2d mean = Vector2d::Zero();
  for (const Seen& seen : track.seen) mean += seen.middle_odom - seen.time * velocity;
  const auto count = static_cast<double>(track.seen.size());
  mean /= count;
  double sum = 0.0;
  for (const Seen& seen : track.seen) sum += (seen.middle_odom - seen.time * velocity - mean).squaredNorm();
  return sum < count * options_.off_line * options_.off_line;
}

/// Legs hide each other, and stand together: what is seen anew beside one that has walked is of the same
/// person.
bool MovingThings::IsBesideWalker(const Vector2d& middle_odom) const {
  return std::ranges::any_of(tracks_, [&](const Track& track) {
    return track.has_moved && (track.seen.back().middle_odom - middle_odom).norm() < options_.body;
  });
}

bool MovingThings::WalksOnUnseen(const Track& track, double time) const {
  return track.has_moved && time - track.seen.back().time < options_.unseen &&
         VelocityOf(track).norm() >= options_.slowest;
}

void MovingThings::Update(std::span<const Vector2d> points_odom, const Vector2d& viewpoint_odom,
                          double time) {
  std::vector<Track> tracks;
  std::vector<bool> taken(tracks_.size(), false);
  for (const Vector2d& middle_odom : MiddlesOf(points_odom, viewpoint_odom)) {
    double nearest = options_.jump;
    std::size_t best = tracks_.size();
    for (std::size_t k = 0; k < tracks_.size(); ++k) {
      if (taken[k]) continue;
      const Seen& last = tracks_[k].seen.back();
      const Vector2d expected = last.middle_odom + VelocityOf(tracks_[k]) * (time - last.time);
      const double distance = (middle_odom - expected).norm();
      if (distance < nearest) nearest = distance, best = k;
    }
    Track track;
    if (best < tracks_.size()) {
      taken[best] = true, track = tracks_[best];
    } else {
      track.has_moved = IsBesideWalker(middle_odom);
    }
    track.seen.push_back({time, middle_odom});
    while (time - track.seen.front().time > options_.memory) track.seen.pop_front();
    track.has_moved = track.has_moved || Walks(track);
    tracks.push_back(std::move(track));
  }
  for (std::size_t k = 0; k < tracks_.size(); ++k) {
    if (!taken[k] && WalksOnUnseen(tracks_[k], time)) tracks.push_back(std::move(tracks_[k]));
  }
  tracks_ = std::move(tracks);
  now_ = time;
}

std::vector<Vector2d> MovingThings::PlacesUntil(
    double later, const std::function<bool(const Vector2d& p_odom)>& stands) const {
  std::vector<Vector2d> places;
  const auto add_body = [&](const Vector2d& middle_odom) {
    for (int k = 0; k < kAround; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / kAround;
      places.emplace_back(middle_odom + options_.body * Vector2d(std::cos(angle), std::sin(angle)));
    }
  };
  for (const Track& track : tracks_) {
    if (!track.has_moved || (stands && stands(track.seen.back().middle_odom))) continue;
    const Vector2d velocity = VelocityOf(track);
    const bool moves = velocity.norm() >= options_.slowest;
    const Vector2d here = track.seen.back().middle_odom + (now_ - track.seen.back().time) * velocity;
    for (double t = 0.0; t < (moves ? later + kPlaceEvery : kPlaceEvery); t += kPlaceEvery)
      add_body(here + std::min(t, later) * velocity);
  }
  return places;
}

}  // namespace ariadne::experiments
