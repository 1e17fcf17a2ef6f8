#include "experiments/metrics/reachable.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <set>

#include "drivers/simulated/outline.h"
#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

using Eigen::Vector3d;
using Cell = std::array<int, 2>;  // steps from the start

constexpr std::array<Cell, 4> kSteps{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};

/// Whether the robot can stand at the cells of a grid around the start, and get from one to the next.
class FreeCells {
 public:
  FreeCells(const drivers::RayScene& scene, const ReachableOptions& options)
      : scene_(scene), o_(options), start_(scene.world().T_map_start.translation) {
    for (const drivers::Body& body : scene.world().bodies) Block(body);
  }

  Vector3d PlaceOf(const Cell& cell) const {
    return {start_.x() + cell[0] * o_.step, start_.y() + cell[1] * o_.step, 0.0};
  }

  bool IsFree(const Cell& cell) const { return !blocked_.contains(cell) && HasFloor(PlaceOf(cell)); }

  /// No surface between two cells, one step apart: with a radius below half a step it may be near neither.
  bool IsOpen(const Cell& from, const Cell& to) const {
    const Vector3d step = PlaceOf(to) - PlaceOf(from);
    for (const double height : {o_.lowest, 0.5 * (o_.lowest + o_.highest), o_.highest}) {
      const Vector3d origin = PlaceOf(from) + height * Vector3d::UnitZ();
      if (scene_.Cast({origin, step.normalized(), 0.0}).distance < step.norm()) return false;
    }
    return true;
  }

 private:
  void Block(const drivers::Body& body) {
    const slam::Pose3 T_map_body = PoseAt(body.motion, 0.0);
    for (const auto& v : body.mesh_body.triangles) {
      const auto& at = body.mesh_body.vertices;
      BlockAround(drivers::OutlineBetween(
          {T_map_body * at[v[0]], T_map_body * at[v[1]], T_map_body * at[v[2]]}, {o_.lowest, o_.highest}));
    }
  }

  void BlockAround(const drivers::Outline& outline_map) {
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector2d& corner : outline_map.corners()) box.extend(corner);
    if (box.isEmpty()) return;
    const Eigen::Array2d low = (box.min() - start_).array() - o_.radius;
    const Eigen::Array2d high = (box.max() - start_).array() + o_.radius;
    const Eigen::Array2i from = (low / o_.step).ceil().cast<int>(),
                         to = (high / o_.step).floor().cast<int>();
    for (int x = from.x(); x <= to.x(); ++x) {
      for (int y = from.y(); y <= to.y(); ++y) {
        const Vector3d place = PlaceOf({x, y});
        if (drivers::DistanceTo(outline_map, place.head<2>()) < o_.radius) blocked_.insert({x, y});
      }
    }
  }

  bool HasFloor(const Vector3d& place) const {
    const Vector3d from = place + o_.highest * Vector3d::UnitZ();
    const double drop = scene_.Cast({from, -Vector3d::UnitZ(), 0.0}).distance;
    return std::abs(drop - o_.highest) <= o_.floor_tolerance;
  }

  const drivers::RayScene& scene_;
  const ReachableOptions& o_;
  Eigen::Vector2d start_;
  std::set<Cell> blocked_;
};

}  // namespace

std::vector<Vector3d> ReachablePlaces(const drivers::RayScene& scene, const ReachableOptions& options) {
  const FreeCells cells(scene, options);
  std::vector<Cell> reached{{0, 0}};
  std::set<Cell> seen{{0, 0}};
  for (std::size_t next = 0; next < reached.size(); ++next) {
    if (reached.size() > options.max_places)
      Fail("{}: more than {} places can be reached: the world has no bounds", scene.world().name,
           options.max_places);
    const Cell here = reached[next];
    for (const Cell& step : kSteps) {
      const Cell there{here[0] + step[0], here[1] + step[1]};
      if (seen.contains(there) || !cells.IsOpen(here, there)) continue;
      seen.insert(there);
      if (cells.IsFree(there)) reached.push_back(there);
    }
  }
  std::vector<Vector3d> places;
  for (const Cell& cell : reached) places.push_back(cells.PlaceOf(cell));
  return places;
}

std::vector<Vector3d> ViewpointsAbove(const std::vector<Vector3d>& places, double spacing, double height) {
  std::set<Cell> seen;
  std::vector<Vector3d> viewpoints;
  for (const Vector3d& place : places) {
    const Cell square{static_cast<int>(std::floor(place.x() / spacing)),
                      static_cast<int>(std::floor(place.y() / spacing))};
    if (seen.insert(square).second) viewpoints.push_back(place + height * Vector3d::UnitZ());
  }
  return viewpoints;
}

}  // namespace ariadne::experiments
