#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "control/drive_limits.h"
#include "control/swept_rectangle.h"

namespace ariadne::control {

/// How what stands in the way changes a command (Sec. 5.3).
struct AvoidanceOptions {
  RectangleOptions robot{0.8, 0.6, 0.0, 0.015, 0.002};
  DriveLimits limits;
  double period = 0.05;
  double reaction = 0.1;
  double slow_distance = 1.0;
  double creep = 0.01;
  double repulsion = 0.6;
  double repulsion_ahead = 0.8;
  double repulsion_beside = 0.06;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit(
        "robot", self.robot,
        "what can hit an obstacle; its margin must be less than what a path is planned with: 1.5 cm is the "
        "scanner's error, and the robot's within a period");
    visit("limits", self.limits, "what the motors can do, braking included");
    visit("period", self.period, Unit("s"), Range{1e-4, 1.0}, "of control");
    visit("reaction", self.reaction, Unit("s"), Range{0.0, 5.0},
          "from the sweep to the wheels: the robot moves on as it does");
    visit("slow_distance", self.slow_distance, Unit("m"), Range{0.01, 100.0},
          "of clear way below which it slows down, in proportion; open in the paper");
    visit("creep", self.creep, Unit("m/s"), Range{0.0, 1.0}, "slower than this it is held up, and stands");
    visit("repulsion", self.repulsion, Unit("rad/s"), Range{0.0, 10.0},
          "of turning away from what is in the way on one side, at full speed; open in the paper");
    visit("repulsion_ahead", self.repulsion_ahead, Unit("m"), Range{0.01, 10.0},
          "of way, where turning away begins; it grows with the square; open in the paper");
    visit("repulsion_beside", self.repulsion_beside, Unit("m"), Range{0.001, 10.0},
          "of what the rectangle sweeps: what stays clear by more does not push; narrow, for doors");
  }
};

struct AvoidanceResult {
  DriveCommand command;                   // at most as fast as wanted
  bool blocked = false;                   // it would move and must stand
  std::optional<Eigen::Vector2d> p_base;  // what slows it down or holds it up
};

/// The command that is carried out instead of a wanted one while the robot moves at `velocity`, given what
/// scanners see now in its frame. Turning away is merged into the turning speed; then both parts are
/// reduced alike: by the clear way of the rectangle along the command's curve, forward or backward or
/// turning in place; and so far that, after the reaction and one period more, the brakes stop the rectangle
/// and its margin before all points. Where nothing does, it brakes. Points that are nearer than the margin
/// may be left or passed along, but not approached. Without points within reach it is the wanted command.
AvoidanceResult Avoid(const DriveCommand& wanted, const DriveCommand& velocity,
                      const std::vector<Eigen::Vector2d>& points_base, const AvoidanceOptions& options);

}  // namespace ariadne::control
