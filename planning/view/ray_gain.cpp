#include "planning/view/ray_gain.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "planning/view/sliding_window.h"
#include "slam/base/error.h"
#include "slam/geometry/angles.h"

namespace ariadne::planning {
namespace {

constexpr double kAngleError = 0.002;  // more than that of RoughAngle [rad]
constexpr double kNearlyHalfTurn = std::numbers::pi - 0.01;

double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The angle of a vector to 0.0016 rad (Rajan et al., IEEE Signal Processing Magazine 23(3), 2006, (9)): it
/// only says which rays to look at, and std::atan2 would be half of the time.
double RoughAngle(const Eigen::Vector2d& v) {
  const double x = std::abs(v.x()), y = std::abs(v.y());
  const double q = std::min(x, y) / std::max({x, y, 1e-300});
  double angle = q * (0.25 * std::numbers::pi + (1.0 - q) * (0.2447 + 0.0663 * q));
  if (y > x) angle = 0.5 * std::numbers::pi - angle;
  if (v.x() < 0.0) angle = std::numbers::pi - angle;
  return std::copysign(angle, v.y());
}

/// Whether the origin is an end of the edge from a to b.
bool IsOnEnd(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.isZero(0.0) || b.isZero(0.0); }

/// Where a ray meets the edge from a to b, both relative to its origin; negative where it does not.
/// `area` is Cross(a, b).
double HitDistance(const Eigen::Vector2d& direction, const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                   double area) {
  if (IsOnEnd(a, b)) return 0.0;
  const double side_a = Cross(direction, a), side_b = Cross(direction, b);
  if ((side_a <= 0.0) == (side_b <= 0.0)) return -1.0;
  return area / (side_b - side_a);
}

/// Rays in order around the circle, the first in [0, number of rays).
struct RaySpan {
  int first = 0;
  int count = 0;
};

/// At least the rays that meet the edge from a to b.
RaySpan RaysToward(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double heading, double step,
                   int rays) {
  const double angle_a = RoughAngle(a), angle_b = RoughAngle(b);
  double turn = angle_b - angle_a;
  if (turn > std::numbers::pi) turn -= 2.0 * std::numbers::pi;
  if (turn < -std::numbers::pi) turn += 2.0 * std::numbers::pi;
  // On which side the edge passes cannot be told from angles where its ends are nearly opposite.
  if (std::abs(turn) > kNearlyHalfTurn || IsOnEnd(a, b)) return {0, rays};
  const double begin = (turn > 0.0 ? angle_a : angle_b) - heading;
  const int first = static_cast<int>(std::ceil((begin - kAngleError) / step));
  const int last = static_cast<int>(std::floor((begin + std::abs(turn) + kAngleError) / step));
  return {(first % rays + rays) % rays, std::min(last - first + 1, rays)};
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
  for (int i = 0; i < options.rays; ++i) {
    direction_.emplace_back(std::cos(heading_ + i * step_), std::sin(heading_ + i * step_));
  }
}

std::vector<RayHit> RayGain::Cast(const Eigen::Vector2d& p_map) const {
  RequirePlaces(std::span(&p_map, 1), "candidate");
  std::vector<RayHit> hits(direction_.size());
  for (const Edge& edge : edges_) Project(edge, p_map, hits);
  return hits;
}

void RayGain::Project(const Edge& edge, const Eigen::Vector2d& p_map, std::span<RayHit> hits) const {
  const Eigen::Vector2d a = edge.from - p_map, b = edge.to - p_map;
  if (IsOutOfRange(a, b, options_.max_range)) return;
  const double area = Cross(a, b);
  const auto [first, count] = RaysToward(a, b, heading_, step_, options_.rays);
  for (int k = 0; k < count; ++k) {
    const auto ray =
        static_cast<std::size_t>(first + k < options_.rays ? first + k : first + k - options_.rays);
    const double distance = HitDistance(direction_[ray], a, b, area);
    RayHit& hit = hits[ray];
    if (!(distance >= 0.0) || distance > hit.distance) continue;
    hit = {distance, edge.seen || (distance == hit.distance && hit.seen)};
  }
}

std::vector<std::uint8_t> RayGain::UnseenRays(const Eigen::Vector2d& p_map) const {
  std::vector<std::uint8_t> counts;
  counts.reserve(direction_.size());
  for (const RayHit& hit : Cast(p_map)) {
    const bool in_range = hit.distance >= options_.min_range && hit.distance <= options_.max_range;
    counts.push_back(in_range && !hit.seen ? 1 : 0);
  }
  return counts;
}

ViewGain RayGain::At(const Eigen::Vector2d& p_map) const {
  // The sum runs from phi to phi + pi, both included; the tolerance keeps 180 deg at 181 rays.
  const double steps = slam::RadFromDeg(options_.field_of_view) / step_;
  const Window best = BestWindow(UnseenRays(p_map), static_cast<int>(std::floor(steps + 1e-9)) + 1);
  return {best.sum, slam::WrapAngle(heading_ + best.center * step_)};
}

}  // namespace ariadne::planning
