#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drivers/simulated/obstacles.h"
#include "drivers/simulated/wheels.h"

namespace ariadne::drivers {

/// The mobile base: what it is by its drawing, how far it trusts its odometry, and how it really is.
struct SimulatedBaseOptions {
  control::DriveGeometry drive;
  control::OdometryOptions odometry;
  WheelsOptions wheels;
  FootprintOptions footprint;
  double step = 0.01;
  double command_timeout = 0.0;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("drive", self.drive, "the wheels by their drawing, as the odometry knows them");
    visit("odometry", self.odometry, "how far the odometry trusts the wheels");
    visit("wheels", self.wheels, "how the wheels really are");
    visit("footprint", self.footprint, "what collides with the world");
    visit("step", self.step, Unit("s"), Range{1e-4, 0.1},
          "of the motion, one arc each: 8 mm at full speed, and how often the encoders are read");
    visit("command_timeout", self.command_timeout, Unit("s"), Range{0.0, 3600.0},
          "after the last command the base brakes by itself, as if nobody drove it any more; 0: it drives "
          "on");
  }
};

/// Where the robot truly was; between two of them it went on an arc, which a straight line approximates.
struct TruePose {
  double time = 0.0;  // [s]
  slam::Pose2 T_map_base;
};

/// Where the world stopped the robot.
struct Collision {
  double time = 0.0;  // [s]
  slam::Pose2 T_map_base;
  std::string thing;  // the body that it touched
};

/// A base that drives through a world. Its true motion goes in steps, each on an exact arc, and stops where
/// the footprint would enter a surface: at the end of each step, the robot overlaps nothing that stands,
/// and comes within a thousandth of a step of what stops it. What walks into the robot overlaps it; the
/// robot may then do what makes the overlap no deeper.
class SimulatedBase {
 public:
  /// Stands at the world's start at time 0. Keeps a reference to the world.
  SimulatedBase(const World& world, const SimulatedBaseOptions& options, std::uint64_t seed);
  SimulatedBase(const World&&, const SimulatedBaseOptions&, std::uint64_t) = delete;

  double Now() const { return now_; }
  /// Holds until the next command, or until the base has waited for that for its command_timeout.
  void Drive(const Velocity& velocity);
  void WaitUntil(double time);

  /// Brakes, and returns when the wheels stand.
  void Halt();

  RobotState State() const;

  const slam::Pose2& T_map_base_true() const { return T_map_base_; }

  /// One per step in which the robot moved, and one before it began to.
  const std::vector<TruePose>& path_true() const { return path_; }

  /// The robot's true way in a span of its past [s], for what measures while it drives.
  Motion WayBetween(double from, double to) const;

  /// Where the world stopped the robot. Pushing on against the same thing counts once.
  const std::vector<Collision>& collisions() const { return collisions_; }

 private:
  double NextStep() const;
  void StepUntil(double time);
  void BrakeIfStale();
  bool MayGoTo(const slam::Pose2& T_map_base, double time) const;
  double ShareUntilContact(const WheelStep& step, double time) const;
  void NoteContact(const slam::Pose2& T_map_wanted, bool stopped);

  Obstacles obstacles_;
  Wheels wheels_;
  control::WheelOdometry odometry_;
  double step_;             // [s]
  double command_timeout_;  // [s]
  double stale_at_;         // when the last command loses its force; infinity: never [s]
  double now_ = 0.0;
  slam::Pose2 T_map_base_;
  std::vector<TruePose> path_;
  std::optional<slam::Pose2> contact_;  // where the robot was stopped, until it is clear of that
  std::vector<Collision> collisions_;
};

}  // namespace ariadne::drivers
