#pragma once

#include <string>

#include "control/drive_limits.h"
#include "control/odometry.h"
#include "drivers/differential_frames.h"
#include "drivers/hardware/dynamixel/servo.h"
#include "drivers/hardware/hobby_servo/hobby_servo.h"
#include "drivers/hardware/lms200/lms200.h"
#include "drivers/hardware/roboclaw/motors.h"
#include "drivers/hardware/servo_kind.h"
#include "slam/geometry/angles.h"
#include "slam/geometry/pose3.h"

namespace ariadne::drivers {

/// The options of a device, and the port that it is on.
template <typename Device>
struct OnPort : Device {
  std::string port;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("port", self.port,
          "that it is on, by a name that stays: /dev/serial/by-id/...; `ariadne devices` lists them");
    Device::Visit(self, visit);
  }
};

/// Where the scanner sits on the base: the tilt axis, and how the level scanner is turned.
struct LaserMountOptions {
  double x = 0.25;
  double y = 0.0;
  double z = 0.95;
  double roll = 0.0;
  double pitch = 0.0;
  double yaw = 0.0;

  slam::Pose3 T_base_laser() const;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("x", self.x, Unit("m"), Range{-10.0, 10.0}, "the tilt axis, ahead of the middle of the wheels");
    visit("y", self.y, Unit("m"), Range{-10.0, 10.0}, "to the left");
    visit("z", self.z, Unit("m"), Range{0.0, 10.0}, "above the floor");
    visit("roll", self.roll, Unit("rad"), Range{-0.5, 0.5}, "of the level scanner, about x; calibrate it");
    visit("pitch", self.pitch, Unit("rad"), Range{-0.5, 0.5}, "about y, positive looks up; calibrate it");
    visit("yaw", self.yaw, Unit("rad"), Range{-3.15, 3.15}, "about z; calibrate it");
  }
};

/// How the scanner is tilted for a 3D scan.
struct TiltOptions {
  int slices = 256;
  double from = slam::RadFromDeg(-55.0);
  double to = slam::RadFromDeg(65.0);
  double fast = 2.0;
  double acceleration = 10.0;
  double window = 0.1;
  double tolerance = 0.01;
  double max_time = 10.0;
  double max_gap = 0.06;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("slices", self.slices, Unit(""), Range{2, 10000},
          "that a scan should have, 256 or 128 in Sec. 2.2; the servo's steps of speed make it 2 % more or "
          "less");
    visit("from", self.from, Unit("rad"), Range{-1.58, 1.58}, "pitch where a scan starts, -55 deg");
    visit("to", self.to, Unit("rad"), Range{-1.58, 1.58}, "pitch where it ends, 65 deg");
    visit("fast", self.fast, Unit("rad/s"), Range{0.05, 20.0}, "between scans");
    visit("acceleration", self.acceleration, Unit("rad/s^2"), Range{0.1, 1000.0},
          "of the mount; it begins before `from`, as far as that takes");
    visit("window", self.window, Unit("s"), Range{0.0, 1.0},
          "the servo's positions within it tell the pitch at its middle: its steps are 1.5 mrad, 1.5 cm at "
          "10 m");
    visit("tolerance", self.tolerance, Unit("rad"), Range{0.001, 0.2}, "of a place that is moved to");
    visit("max_time", self.max_time, Unit("s"), Range{0.5, 100.0}, "for a motion, beyond what it takes");
    visit("max_gap", self.max_gap, Unit("rad"), Range{0.001, 3.2},
          "between slices; a scan with a larger one is taken again, as bytes were lost on a line");
  }
};

/// How far before its range the mount must begin to move so that it is even there: at `rate` [rad/s], for
/// sweeps of a duration [s], with a mount that follows by a lag [s].
double LeadOf(const TiltOptions& tilt, double rate, double duration, double lag = 0.0);

/// When wheels that should turn are held by something.
struct StallOptions {
  double time = 0.4;
  double share = 0.2;
  double min_speed = 0.01;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("time", self.time, Unit("s"), Range{0.05, 10.0}, "that a wheel must stay behind its command");
    visit("share", self.share, Unit(""), Range{0.0, 1.0}, "of the commanded speed, below which it does");
    visit("min_speed", self.min_speed, Unit("m/s"), Range{0.001, 1.0}, "slower commands say nothing");
  }
};

struct HardwareRobotOptions {
  OnPort<Lms200Options> scanner;
  ServoKind servo_kind = ServoKind::kDynamixel;
  OnPort<dynamixel::ServoOptions> servo;
  hobby_servo::HobbyServoOptions hobby_servo;
  OnPort<roboclaw::MotorsOptions> motors;
  LaserMountOptions mount;
  TiltOptions tilt;
  control::DriveGeometry drive;
  control::OdometryOptions odometry;
  control::DriveLimits limits;
  bool swapped = false;
  bool left_reversed = false;
  bool right_reversed = false;
  double wheel_acceleration = 0.75;
  StallOptions stall;
  double state_age = 0.02;
  double sweep_age = 0.1;
  DifferentialFrameOptions frames;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("scanner", self.scanner, "the LMS-200");
    visit(
        "servo_kind", self.servo_kind,
        "what tilts it, on the port servo.port: a Dynamixel, which measures where it is, or a hobby servo "
        "on a Maestro, which follows by hobby_servo.lag");
    visit("servo", self.servo, "the Dynamixel");
    visit("hobby_servo", self.hobby_servo, "the hobby servo and its controller");
    visit("motors", self.motors, "the RoboClaw that drives the wheels");
    visit("mount", self.mount, "where the scanner sits on the base");
    visit("tilt", self.tilt, "how a 3D scan is taken");
    visit("drive", self.drive, "the wheels and their encoders");
    visit("odometry", self.odometry, "how far the odometry trusts them");
    visit("limits", self.limits, "of speed; faster commands are reduced, their curve stays");
    visit("swapped", self.swapped, "motor 1 is the right wheel, else the left one");
    visit("left_reversed", self.left_reversed, "whether the left motor counts backwards");
    visit("right_reversed", self.right_reversed, "whether the right motor counts backwards");
    visit("wheel_acceleration", self.wheel_acceleration, Unit("m/s^2"), Range{0.01, 100.0},
          "of a rim, also of braking: 0.5 m/s^2 ahead and 1 rad/s^2 at a track of 50 cm");
    visit("stall", self.stall, "when something holds the wheels");
    visit("state_age", self.state_age, Unit("s"), Range{0.0, 1.0},
          "how old an answer about the wheels may be before they are asked again, which takes 14 ms at "
          "38400 baud");
    visit(
        "sweep_age", self.sweep_age, Unit("s"), Range{0.01, 5.0},
        "how old a sweep may be while driving; where none is newer, the wheels stop, and it is waited for");
    visit("frames", self.frames, "when a scan is repeated because something moved (Sec. 3.4)");
  }
};

}  // namespace ariadne::drivers
