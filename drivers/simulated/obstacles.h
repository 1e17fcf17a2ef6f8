#pragma once

#include <cstdint>
#include <vector>

#include "drivers/simulated/outline.h"
#include "drivers/simulated/world.h"
#include "slam/base/options.h"

namespace ariadne::drivers {

/// The room that the robot takes: an upright block, its origin midway between the wheels on the floor.
struct FootprintOptions {
  double length = 0.8;
  double width = 0.6;
  double lowest = 0.05;
  double highest = 0.9;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("length", self.length, Unit("m"), Range{0.01, 10.0}, "Sec. 2.1; the wheels are in the middle");
    visit("width", self.width, Unit("m"), Range{0.01, 10.0}, "Sec. 2.1");
    visit("lowest", self.lowest, Unit("m"), Range{0.0, 10.0},
          "lower things are driven over: the floor's unevenness, thresholds, cables");
    visit("highest", self.highest, Unit("m"), Range{0.0, 10.0}, "90 cm high (Sec. 2.1)");
  }
};

/// Where the robot meets the world.
struct Contact {
  double depth = 0.0;      // it must be shifted so far to be free, at least [m]; 0: free
  std::uint32_t body = 0;  // index into World::bodies, of the deepest
};

/// What of a world is in the way of a robot. Exact for the surfaces: the block against the part of each
/// triangle between its lowest and highest. A robot that is wholly inside of something hollow is free: it
/// cannot get there by driving, since surfaces do not let it through in steps shorter than itself.
class Obstacles {
 public:
  /// Keeps a reference to the world.
  Obstacles(const World& world, const FootprintOptions& footprint);
  Obstacles(const World&&, const FootprintOptions&) = delete;

  /// The deepest contact of the robot at a pose, with moving bodies where they are at a time [s].
  Contact ContactAt(const slam::Pose2& T_map_base, double time) const;

  const std::string& NameOf(std::uint32_t body) const { return world_->bodies[body].name; }

  /// Whether something keeps the robot from a short step. Nothing that stands lets it in. A moving body may
  /// have walked into the robot, which can then do whatever does not bring it nearer to that body's middle.
  bool Block(const slam::Pose2& T_map_from, const slam::Pose2& T_map_to, double time) const;

 private:
  /// Part of a body that stands.
  struct Standing {
    Outline outline_map;
    std::uint32_t body;
  };
  /// A body that moves, in a sphere.
  struct Moving {
    Eigen::Vector3d center_body;
    double radius;  // [m]
    std::uint32_t body;
  };
  /// Cells of the grid; from <= to.
  struct Cells {
    Eigen::Vector2i from, to;
  };

  void AddStanding(std::uint32_t body);
  void AddMoving(std::uint32_t body);
  void FillGrid();
  Cells CellsAround(std::span<const Eigen::Vector2d> points) const;
  std::size_t CellAt(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(grid_size_.x()) +
           static_cast<std::size_t>(x);
  }
  Contact TouchStanding(const slam::Pose2& T_map_base) const;
  double TouchMoving(const Moving& moving, const slam::Pose2& T_map_base, double time) const;
  Eigen::Vector2d Middle(const Moving& moving, double time) const;

  const World* world_;
  Eigen::Vector2d half_size_;
  HeightRange heights_;
  std::vector<Moving> moving_;
  std::vector<Standing> standing_;
  Eigen::Vector2d grid_origin_ = Eigen::Vector2d::Zero();
  double cell_size_ = 0.5;  // [m]
  Eigen::Vector2i grid_size_ = Eigen::Vector2i::Zero();
  std::vector<std::vector<std::uint32_t>> grid_;  // of each cell, what of standing_ is in it
};

}  // namespace ariadne::drivers
