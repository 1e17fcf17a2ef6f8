#include "planning/view/ray_gain.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "slam/base/error.h"
#include "slam/geometry/angles.h"

namespace ariadne::planning {
namespace {

constexpr double kAngleError = 0.002;         // more than that of RoughAngle [rad]
constexpr double kPartsPerSquareMeter = 1e4;  // areas are summed as whole numbers, in any order the same
constexpr double kNearlyHalfTurn = std::numbers::pi - 0.01;

double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The angle of a vector to 0.0016 rad (after Rajan et al., IEEE Signal Processing Magazine 23(3), 2006,
/// (9)): it only says which rays to look at, and std::atan2 would be half of the time. Without branches, so
/// that compilers turn a loop over it into vectors.
float RoughAngle(float vx, float vy) {
  constexpr float kHalf = 0.5f * std::numbers::pi_v<float>;  // a right angle
  const float x = std::abs(vx), y = std::abs(vy);
  const float q = (x - y) / (x + y + 1e-30f), r = std::abs(q);
  const float off_diagonal = q * (0.5f * kHalf + (1.0f - r) * (0.2447f + 0.0663f * r));
  const float from_y = 0.5f * kHalf + off_diagonal;  // the angle to the nearer half of the y axis
  return std::copysign(kHalf - std::copysign(from_y, vx), vy);
}

/// Whether the origin is an end of the edge from a to b.
bool IsOnEnd(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.isZero(0.0) || b.isZero(0.0); }

/// Where a ray meets the edge from a to b, both relative to its origin; negative where it does not.
/// `area` is Cross(a, b).
double HitDistance(const Eigen::Vector2d& direction, const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                   double area) {
  const double side_a = Cross(direction, a), side_b = Cross(direction, b);
  if ((side_a <= 0.0) == (side_b <= 0.0)) return -1.0;
  return area / (side_b - side_a);
}

/// Rays in order around the circle, the first in [0, number of rays).
struct RaySpan {
  int first = 0;
  int count = 0;
};

/// At least the rays that meet an edge whose ends are in these directions [rad].
RaySpan RaysToward(float angle_a, float angle_b, double heading, double rays_per_radian, int rays) {
  double turn = static_cast<double>(angle_b) - static_cast<double>(angle_a);
  if (turn > std::numbers::pi) turn -= 2.0 * std::numbers::pi;
  if (turn < -std::numbers::pi) turn += 2.0 * std::numbers::pi;
  // On which side the edge passes cannot be told from angles where its ends are nearly opposite.
  if (std::abs(turn) > kNearlyHalfTurn) return {0, rays};
  const double begin = static_cast<double>(turn > 0.0 ? angle_a : angle_b) - heading;
  int first = static_cast<int>(std::ceil((begin - kAngleError) * rays_per_radian));
  const int last = static_cast<int>(std::floor((begin + std::abs(turn) + kAngleError) * rays_per_radian));
  const int count = std::min(last - first + 1, rays);
  while (first < 0) first += rays;  // once, or twice: the begin is within one turn
  while (first >= rays) first -= rays;
  return {first, count};
}

/// Of all corners as seen from a place.
std::vector<float> RoughAngles(std::span<const double> x_map, std::span<const double> y_map,
                               const Eigen::Vector2d& p_map) {
  std::vector<float> angles(x_map.size());
  const double px = p_map.x(), py = p_map.y();
  for (std::size_t i = 0; i < angles.size(); ++i) {
    angles[i] = RoughAngle(static_cast<float>(x_map[i] - px), static_cast<float>(y_map[i] - py));
  }
  return angles;
}

/// Whether the box around the edge leaves the square of what is in range.
bool IsOutOfRange(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double range) {
  return std::min(a.x(), b.x()) > range || std::max(a.x(), b.x()) < -range ||
         std::min(a.y(), b.y()) > range || std::max(a.y(), b.y()) < -range;
}

}  // namespace

RayGain::RayGain(std::span<const Edge> edges, double heading, const RayGainOptions& options)
    : edges_(edges), heading_(slam::WrapAngle(heading)), options_(options) {
  CheckOptions(options, "gain.");
  if (options.min_range > options.max_range) {
    Fail("gain.min_range is {} m and gain.max_range {} m: no hit is within both", options.min_range,
         options.max_range);
  }
  if (!std::isfinite(heading)) Fail("the robot's heading is {}, which is no angle", heading);
  RequirePlaces(edges);
  step_ = 2.0 * std::numbers::pi / options.rays;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (i == 0 || edges[i].from != edges[i - 1].to) AddCorner(edges[i].from);
    AddCorner(edges[i].to);
    corner_to_.push_back(corner_x_.size() - 1);
  }
  for (int i = 0; i < options.rays; ++i) {
    direction_.emplace_back(std::cos(heading_ + i * step_), std::sin(heading_ + i * step_));
  }
}

void RayGain::AddCorner(const Eigen::Vector2d& p_map) {
  corner_x_.push_back(p_map.x());
  corner_y_.push_back(p_map.y());
}

std::vector<RayHit> RayGain::Cast(const Eigen::Vector2d& p_map) const {
  RequirePlaces(std::span(&p_map, 1), "candidate");
  std::vector<RayHit> hits(direction_.size());
  const std::vector<float> angles = RoughAngles(corner_x_, corner_y_, p_map);
  const double rays_per_radian = 1.0 / step_;
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const Eigen::Vector2d a = edges_[i].from - p_map, b = edges_[i].to - p_map;
    if (IsOutOfRange(a, b, options_.max_range)) continue;
    if (IsOnEnd(a, b)) {
      for (RayHit& hit : hits) Meet(i, 0.0, hit);
    } else {
      const std::size_t to = corner_to_[i];
      const RaySpan span = RaysToward(angles[to - 1], angles[to], heading_, rays_per_radian, options_.rays);
      Project(i, a, b, span.first, span.count, hits);
    }
  }
  return hits;
}

void RayGain::Project(std::size_t edge, const Eigen::Vector2d& a, const Eigen::Vector2d& b, int first,
                      int count, std::span<RayHit> hits) const {
  const double area = Cross(a, b);
  auto ray = static_cast<std::size_t>(first);
  for (int k = 0; k < count; ++k) {
    const double distance = HitDistance(direction_[ray], a, b, area);
    if (distance >= 0.0) Meet(edge, distance, hits[ray]);
    if (++ray == hits.size()) ray = 0;
  }
}

/// A ray meets an edge: its first one, one as near, or one behind.
void RayGain::Meet(std::size_t edge, double distance, RayHit& hit) const {
  if (distance > hit.distance) {
    hit.beyond = std::min(hit.beyond, distance);
  } else {
    const bool seen = edges_[edge].seen || (distance == hit.distance && hit.seen);
    hit = {distance, seen, false, edge, hit.distance};
  }
}

bool RayGain::IsUnseen(const RayHit& hit) const {
  return !hit.seen && !hit.spent && hit.distance >= options_.min_range &&
         hit.distance <= options_.max_range;
}

double RayGain::AreaBehind(const RayHit& hit) const {
  double end = std::min(hit.distance + options_.depth, options_.max_range);
  if (options_.until_known) end = std::min(end, hit.beyond);
  return 0.5 * step_ * (end * end - hit.distance * hit.distance);
}

double RayGain::GainOf(const RayHit& hit) const {
  return options_.measure == GainMeasure::kArea ? AreaBehind(hit) : 1.0;
}

double RayGain::GainAllAround(std::span<const RayHit> hits) const {
  double gain = 0.0;
  for (const RayHit& hit : hits) gain += IsUnseen(hit) ? GainOf(hit) : 0.0;
  return gain;
}

ViewGain RayGain::At(const Eigen::Vector2d& p_map) const { return Of(Cast(p_map)); }

ViewGain RayGain::Of(std::span<const RayHit> hits, double min_overlap) const {
  std::vector<int> values(hits.size(), 0), known(hits.size(), 0);
  for (std::size_t i = 0; i < hits.size(); ++i) {
    known[i] = IsKnown(hits[i]) ? 1 : 0;
    if (!IsUnseen(hits[i])) continue;
    const bool by_area = options_.measure == GainMeasure::kArea;
    values[i] = by_area ? static_cast<int>(std::lround(kPartsPerSquareMeter * AreaBehind(hits[i]))) : 1;
  }
  // The sum runs from phi to phi + pi, both included; the tolerance keeps 180 deg at 181 rays.
  const double steps = slam::RadFromDeg(options_.field_of_view) / step_;
  const int width = static_cast<int>(std::floor(steps + 1e-9)) + 1;
  const ViewGain best = About(BestWindow(values, width), hits);
  if (best.overlap >= min_overlap) return best;
  const std::optional<Window> other = BestWindowWith(values, width, known, min_overlap);
  return other ? About(*other, hits) : best;
}

/// What a field of view about the middle of a window shows.
ViewGain RayGain::About(const Window& window, std::span<const RayHit> hits) const {
  ViewGain view;
  view.direction = slam::WrapAngle(heading_ + window.center * step_);
  const std::vector<std::size_t> rays = RaysAbout(view.direction);
  int known = 0;
  for (const std::size_t i : rays) {
    known += IsKnown(hits[i]) ? 1 : 0;
    if (!IsUnseen(hits[i])) continue;
    ++view.gain;
    view.area += AreaBehind(hits[i]);
  }
  // About a direction between two rays there is one ray less than in the window.
  if (options_.measure == GainMeasure::kRays) view.gain = window.sum;
  const double gain = options_.measure == GainMeasure::kArea ? view.area : view.gain;
  if (gain > 0.0) view.shown = std::min(1.0, gain / GainAllAround(hits));
  view.overlap = static_cast<double>(known) / static_cast<double>(std::max<std::size_t>(1, rays.size()));
  return view;
}

std::vector<std::size_t> RayGain::RaysAbout(double direction) const {
  const double center = slam::WrapAngle(direction - heading_) / step_;
  const double half = 0.5 * slam::RadFromDeg(options_.field_of_view) / step_ + 1e-9;
  const auto n = static_cast<long>(direction_.size());
  const auto first = static_cast<long>(std::ceil(center - half));
  const long count = std::min(static_cast<long>(std::floor(center + half)) - first + 1, n);
  std::vector<std::size_t> rays;
  for (long i = 0; i < count; ++i) rays.push_back(static_cast<std::size_t>(((first + i) % n + n) % n));
  return rays;
}

}  // namespace ariadne::planning
