#pragma once

#include <array>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "control/odometry.h"
#include "drivers/hardware/robot/hardware_robot_options.h"
#include "drivers/hardware/robot/tilt_mount.h"
#include "drivers/hardware/robot/tilt_track.h"
#include "drivers/robot.h"

namespace ariadne::drivers {

/// The lines to the devices. They have one clock: that of the system, or that of an emulation.
struct RobotLines {
  std::unique_ptr<ByteStream> scanner;
  std::unique_ptr<ByteStream> servo;
  std::unique_ptr<ByteStream> motors;
};

/// A robot of three devices: an LMS-200, a servo that tilts it, and a RoboClaw that drives two wheels. It
/// looks at no clock but that of its lines, and so is a function of what crosses them: emulated, real or
/// recorded.
///
/// A 3D scan is organized as the simulator's: the mount turns evenly upwards while sweeps come by
/// themselves, and the pitch of each is what the servo has measured around its time. Before and after it
/// the level scanner looks whether something has moved. While driving the scanner is level and streams, so
/// that a sweep is at hand at any time; there are no safety scanners.
///
/// The board of the motors stops them by itself when it hears nothing for its timeout, which is set at the
/// start and read back. Where a call throws, whatever failed, the motors were told to stop before, or could
/// not be told, and stop by their timeout.
class HardwareRobot : public Robot {
 public:
  HardwareRobot(RobotLines lines, const HardwareRobotOptions& options);
  ~HardwareRobot() override;

  /// Finds all devices and sets them up; the scanner is level then. Error that says which one cannot be
  /// used and why. Comes before all other calls.
  void Connect();

  double Now() const override;
  slam::Pose3 T_base_laser() const override { return options_.mount.T_base_laser(); }

  /// A scan in which something moved is taken again, up to frames.max_repeats times, and then kept.
  slam::Scan TakeScan() override;

  /// The newest one.
  slam::LaserSweep TakeSweep() override;

  std::vector<SafetySweep> TakeSafetySweeps() override { return {}; }
  RobotState State() override;
  void Drive(const Velocity& velocity) override;
  void WaitUntil(double time) override;

  /// For a display of what the devices say.
  const Lms200& scanner() const { return scanner_; }
  roboclaw::Motors& motors() { return motors_; }
  int repeated_scans() const { return repeated_scans_; }
  /// How often the wheels were stopped because the board was silent.
  int interruptions() const { return interruptions_; }

 private:
  template <typename Call>
  auto StoppingWheels(Call call) -> decltype(call());
  void StopWheels() noexcept;

  // hardware_robot.cpp
  double LineNow() const;
  void ReadBase();
  void NoteInterruption();
  void NoteStall(const control::WheelPair& speeds);
  void Halt();

  // hardware_scan.cpp
  void WaitForMount(double angle);
  void Level();
  void Stream();
  void KeepSweepsUntil(double line_time);
  slam::LaserSweep SweepAfter(double line_time);
  std::optional<slam::Scan> TryScan();
  std::vector<slam::LaserSweep> SweepsWhileTilting(TiltTrack& track);
  std::optional<slam::Scan> ScanOf(std::vector<slam::LaserSweep> sweeps, const TiltTrack& track) const;
  double TiltRate() const;
  double SweepDuration() const;
  slam::LaserSweep Stamped(slam::LaserSweep sweep) const;

  HardwareRobotOptions options_;
  ByteStream& base_line_;  // its clock is the robot's
  Lms200 scanner_;
  std::unique_ptr<TiltMount> mount_;
  roboclaw::Motors motors_;
  double start_;                            // of the robot's time, by the lines' clock [s]
  bool level_ = false;                      // the mount stands level
  bool levelling_ = false;                  // it is on its way there
  std::optional<slam::LaserSweep> latest_;  // level, by the lines' clock
  control::WheelOdometry odometry_;
  RobotState state_;
  double state_read_ = -1e9;               // when, by the lines' clock [s]
  control::WheelPair target_;              // that the wheels were told [m/s]
  std::array<double, 2> behind_since_{};   // when each began to stay behind its command [s]
  std::optional<slam::Pose2> stalled_at_;  // until the robot is clear of it
  int repeated_scans_ = 0;
  int interruptions_ = 0;
};

/// Opens the ports that the options name. Error that says which one is not given, or cannot be opened.
RobotLines OpenPorts(const HardwareRobotOptions& options);

}  // namespace ariadne::drivers
