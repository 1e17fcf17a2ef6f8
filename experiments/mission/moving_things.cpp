#include "experiments/mission/moving_things.h"

#include <algorithm>
#include <limits>

namespace ariadne::experiments {
namespace {

using Eigen::Vector2d;

constexpr double kPlaceEvery = 0.12;  // between the places of a moving thing [s]

}  // namespace

std::vector<MovingThings::Run> MovingThings::RunsOf(std::span<const Vector2d> points_odom) const {
  std::vector<Run> runs;
  for (std::size_t first = 0; first < points_odom.size();) {
    std::size_t end = first + 1;
    while (end < points_odom.size() && (points_odom[end] - points_odom[end - 1]).norm() < options_.gap)
      ++end;
    const Vector2d &from = points_odom[first], &to = points_odom[end - 1];
    if ((to - from).norm() < options_.largest) {
      Vector2d sum = Vector2d::Zero();
      for (std::size_t i = first; i < end; ++i) sum += points_odom[i];
      runs.push_back({sum / static_cast<double>(end - first), {from, points_odom[(first + end) / 2], to}});
    }
    first = end;
  }
  return runs;
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

void MovingThings::Update(std::span<const Vector2d> points_odom, double time) {
  std::vector<Run> runs = RunsOf(points_odom);
  std::vector<Track> tracks;
  std::vector<bool> taken(tracks_.size(), false);
  for (Run& run : runs) {
    double nearest = options_.jump;
    std::size_t best = tracks_.size();
    for (std::size_t k = 0; k < tracks_.size(); ++k) {
      if (taken[k]) continue;
      const Seen& last = tracks_[k].seen.back();
      const Vector2d expected = last.middle_odom + VelocityOf(tracks_[k]) * (time - last.time);
      const double distance = (run.middle_odom - expected).norm();
      if (distance < nearest) nearest = distance, best = k;
    }
    Track track;
    if (best < tracks_.size()) taken[best] = true, track = std::move(tracks_[best]);
    track.seen.push_back({time, run.middle_odom});
    while (time - track.seen.front().time > options_.memory) track.seen.pop_front();
    track.now = std::move(run);
    tracks.push_back(std::move(track));
  }
  tracks_ = std::move(tracks);
}

std::vector<Vector2d> MovingThings::PlacesUntil(double later) const {
  std::vector<Vector2d> places;
  for (const Track& track : tracks_) {
    const Vector2d velocity = VelocityOf(track);
    if (velocity.norm() < options_.slowest) continue;
    for (double t = kPlaceEvery; t < later + kPlaceEvery; t += kPlaceEvery) {
      for (const Vector2d& p_odom : track.now.outline_odom)
        places.emplace_back(p_odom + std::min(t, later) * velocity);
    }
  }
  return places;
}

}  // namespace ariadne::experiments
