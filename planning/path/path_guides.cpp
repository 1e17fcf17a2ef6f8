#include "planning/path/path_guides.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "slam/geometry/angles.h"

namespace ariadne::planning::internal {
namespace {

constexpr double kGuideStep = 0.25, kGuideShift = 0.05;                    // [m]
constexpr int kGuideHeadings = 30;                                         // to each side
constexpr double kGuideHeading = 0.5 * std::numbers::pi / kGuideHeadings;  // [rad]

/// Across the way to where most room is, if there is little: the shortest way of a disc touches the corners
/// of a door, and the robot needs its middle.
Eigen::Vector2d Centred(const FreeSpace& space, const Eigen::Vector2d& p_map, const Eigen::Vector2d& side,
                        double enough) {
  Eigen::Vector2d best = p_map;
  double most = std::min(enough, space.Clearance(p_map));
  for (double away = kGuideShift; away < enough; away += kGuideShift) {
    for (const double sign : {-1.0, 1.0}) {
      const Eigen::Vector2d p = p_map + sign * away * side;
      const double clearance = std::min(enough, space.Clearance(p));
      if (clearance > most + 1e-9) most = clearance, best = p;
    }
  }
  return best;
}

slam::Pose2 WithCentre(const Eigen::Vector2d& p_map, double heading, const Footprint& footprint) {
  const Eigen::Vector2d axis(std::cos(heading), std::sin(heading));
  return {slam::WrapAngle(heading), p_map - footprint.options().centre_ahead * axis};
}

/// The middle of the headings, within a right angle of the way's, in which the robot fits there.
std::optional<double> FittingHeading(const FreeSpace& space, const Footprint& footprint,
                                     const slam::Pose2& T_map_way) {
  const auto fits = [&](int i) {
    return std::abs(i) <= kGuideHeadings &&
           footprint.IsFree(
               space, WithCentre(T_map_way.translation, T_map_way.angle + i * kGuideHeading, footprint));
  };
  if (fits(0) && fits(-2) && fits(2)) return T_map_way.angle;
  for (int i = 0; i <= kGuideHeadings; ++i) {
    for (const int sign : {-1, 1}) {
      if (!fits(sign * i)) continue;
      int low = sign * i, high = low;
      while (fits(low - 1)) --low;
      while (fits(high + 1)) ++high;
      return T_map_way.angle + 0.5 * (low + high) * kGuideHeading;
    }
  }
  return std::nullopt;
}

std::vector<slam::Pose2> GuidesAlong(const FreeSpace& space, const Footprint& footprint,
                                     const std::vector<Eigen::Vector2d>& way) {
  std::vector<slam::Pose2> guides;
  const double enough = footprint.reach() + footprint.options().margin;
  for (std::size_t i = 1; i < way.size(); ++i) {
    const Eigen::Vector2d along = way[i] - way[i - 1];
    const int count = std::max(1, static_cast<int>(std::ceil(along.norm() / kGuideStep)));
    const Eigen::Vector2d side = Eigen::Vector2d(-along.y(), along.x()).normalized();
    for (int k = 0; k < count; ++k) {
      const Eigen::Vector2d p = Centred(space, way[i - 1] + along * (k + 0.5) / count, side, enough);
      const slam::Pose2 guide{std::atan2(along.y(), along.x()), p};
      if (const auto heading = FittingHeading(space, footprint, guide))
        guides.push_back(WithCentre(p, *heading, footprint));
    }
  }
  return guides;
}

}  // namespace

std::vector<slam::Pose2> FindGuides(const FreeSpace& space, const Footprint& footprint,
                                    const GeodesicField& reachable, const slam::Pose2& T_map_start,
                                    const slam::Pose2& T_map_goal) {
  const Eigen::Vector2d goal_map = footprint.CentreAt(T_map_goal);
  const GeodesicField field =
      DistancesFrom(space, footprint.CentreAt(T_map_start), footprint.least_radius());
  std::vector<Eigen::Vector2d> way = field.PathTo(goal_map);
  if (way.empty()) way = reachable.PathTo(goal_map);
  return GuidesAlong(space, footprint, way);
}

std::vector<std::size_t> StopsAmong(const FreeSpace& space, const std::vector<slam::Pose2>& guides,
                                    double least, double most) {
  std::vector<std::size_t> stops;
  double since = 0.0, widest = -1.0;  // since the last stop [m], and the clearance of the next so far [m]
  std::size_t best = 0;
  for (std::size_t i = 1; i < guides.size(); ++i) {
    since += (guides[i].translation - guides[i - 1].translation).norm();
    const double clearance = space.Clearance(guides[i].translation);
    if (since >= least && clearance > widest) widest = clearance, best = i;
    if (since < most || i + 1 == guides.size()) continue;
    stops.push_back(best);
    i = best;
    since = 0.0, widest = -1.0;
  }
  return stops;
}

PathSamples SamplesOf(const FreeSpace& space, const GeodesicField& reachable,
                      const std::vector<slam::Pose2>& guides, double around) {
  Cell low{0, 0}, high{space.columns() - 1, space.rows() - 1};
  if (std::isfinite(around) && !guides.empty()) {
    Eigen::Vector2d least = guides.front().translation, most = least;
    for (const slam::Pose2& guide : guides) {
      least = least.cwiseMin(guide.translation);
      most = most.cwiseMax(guide.translation);
    }
    const Cell first = space.CellOf(least.array() - around), last = space.CellOf(most.array() + around);
    low = {std::max(low.column, first.column), std::max(low.row, first.row)};
    high = {std::min(high.column, last.column), std::min(high.row, last.row)};
  }
  PathSamples samples{guides, {}, space.resolution()};
  for (int row = low.row; row <= high.row; ++row) {
    for (int column = low.column; column <= high.column; ++column) {
      if (reachable.IsReachable({column, row})) samples.cells.push_back(space.CentreOf({column, row}));
    }
  }
  return samples;
}

}  // namespace ariadne::planning::internal
