#include "control/path_leg.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "slam/geometry/angles.h"

namespace ariadne::control {
namespace {

using slam::Pose2;

constexpr double kNothing = 1e-6;       // that moves [m, rad]
constexpr double kTurnRadius = 0.01;    // curves below it are turns in place [m]
constexpr double kArcDeviation = 0.35;  // of a chord from the mean heading, beyond which it is no arc [rad]

struct PathStep {
  LegKind kind = LegKind::kForward;
  double way = 0.0;        // [m]
  double turn = 0.0;       // [rad]
  double direction = 0.0;  // of motion [rad]
};

Eigen::Vector2d HeadingOf(const Pose2& pose) { return {std::cos(pose.angle), std::sin(pose.angle)}; }

/// None where nothing moves.
std::optional<PathStep> StepBetween(const Pose2& from, const Pose2& to) {
  const Eigen::Vector2d moved = to.translation - from.translation;
  PathStep step{LegKind::kTurn, moved.norm(), slam::WrapAngle(to.angle - from.angle), 0.0};
  if (step.way < kNothing && std::abs(step.turn) < kNothing) return {};
  if (step.way <= kTurnRadius * std::abs(step.turn)) return step;
  const double along = moved.dot(HeadingOf(from) + HeadingOf(to)) / step.way;
  step.kind = along < -1e-9 ? LegKind::kBackward : LegKind::kForward;
  step.direction = std::atan2(moved.y(), moved.x());
  return step;
}

/// Whether one leg can hold both, one after the other.
bool GoesOn(const PathStep& before, const PathStep& step, double corner) {
  if (before.kind != step.kind) return false;
  if (step.kind == LegKind::kTurn) return (before.turn > 0.0) == (step.turn > 0.0);
  // A tight arc turns much between two chords, but so do its headings.
  const double jump = std::abs(slam::WrapAngle(step.direction - before.direction));
  return jump <= corner;
}

}  // namespace

PathLeg LegFrom(const std::vector<Pose2>& path, std::size_t first, double corner) {
  PathLeg leg{LegKind::kForward, first, first, 0.0};
  std::optional<PathStep> before;
  for (std::size_t k = first; k + 1 < path.size(); ++k) {
    const std::optional<PathStep> step = StepBetween(path[k], path[k + 1]);
    if (step && before && !GoesOn(*before, *step, corner)) break;
    leg.last = k + 1;
    if (!step) continue;
    before = step;
    leg.kind = step->kind;
    leg.length += step->kind == LegKind::kTurn ? step->turn : step->way;
  }
  return leg;
}

std::vector<PathLeg> LegsOf(const std::vector<Pose2>& path, double corner) {
  std::vector<PathLeg> legs;
  for (std::size_t first = 0; first + 1 < path.size(); first = legs.back().last) {
    legs.push_back(LegFrom(path, first, corner));
  }
  return legs;
}

DrivenLeg::DrivenLeg(const std::vector<Pose2>& path, const PathLeg& leg)
    : path_(path), leg_(leg), ways_{0.0} {
  for (std::size_t k = leg.first; k < leg.last; ++k) {
    ways_.push_back(ways_.back() + (path[k + 1].translation - path[k].translation).norm());
  }
}

Pose2 DrivenLeg::MotionAt(double way) const {
  if (leg_.first == leg_.last) return path_[leg_.first];
  // The step that holds it, which moves.
  const double within = std::clamp(way, kNothing, std::max(kNothing, length()));
  const auto after = std::min(std::lower_bound(ways_.begin() + 1, ways_.end(), within), ways_.end() - 1);
  auto k = static_cast<std::size_t>(after - ways_.begin());
  while (k > 1 && ways_[k] - ways_[k - 1] < kNothing) --k;  // the direction of a rounding error is none
  const double chord = ways_[k] - ways_[k - 1];
  Pose2 from = path_[leg_.first + k - 1], to = path_[leg_.first + k];
  const Eigen::Vector2d moved = to.translation - from.translation;
  if (leg_.kind == LegKind::kBackward) {
    from.angle = slam::WrapAngle(from.angle + std::numbers::pi);
    to.angle = slam::WrapAngle(to.angle + std::numbers::pi);
  }
  const double direction = std::atan2(moved.y(), moved.x());
  const double turn = slam::WrapAngle(to.angle - from.angle);
  const double mean = from.angle + 0.5 * turn;
  if (std::abs(slam::WrapAngle(direction - mean)) > kArcDeviation) from.angle = to.angle = direction;
  const double share = chord > 0.0 ? (way - ways_[k - 1]) / chord : 0.0;
  const Pose2 on_leg = Interpolate(from, to, std::clamp(share, 0.0, 1.0));
  const double beyond = way < 0.0 ? way : std::max(0.0, way - length());
  return {on_leg.angle, on_leg.translation + beyond * HeadingOf(on_leg)};
}

double DrivenLeg::NearestWay(const Eigen::Vector2d& p_map, double from, double to) const {
  double nearest = std::numeric_limits<double>::infinity();
  double best = from;
  for (std::size_t k = 1; k < ways_.size(); ++k) {
    const double low = std::max(from, ways_[k - 1]), high = std::min(to, ways_[k]);
    if (low > high) continue;
    const Eigen::Vector2d& a = path_[leg_.first + k - 1].translation;
    const double chord = ways_[k] - ways_[k - 1];
    const Eigen::Vector2d along = chord > 0.0
                                      ? Eigen::Vector2d((path_[leg_.first + k].translation - a) / chord)
                                      : Eigen::Vector2d(0.0, 0.0);
    const double way = std::clamp(ways_[k - 1] + (p_map - a).dot(along), low, high);
    const double distance = (a + (way - ways_[k - 1]) * along - p_map).norm();
    if (distance < nearest) nearest = distance, best = way;
  }
  return best;
}

}  // namespace ariadne::control
