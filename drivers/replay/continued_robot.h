#pragma once

#include "drivers/replay/log_cursor.h"
#include "drivers/robot.h"

namespace ariadne::drivers {

/// A robot that was started anew, in the time and the odometry of a log that it goes on with. Its clock and
/// its odometry may have begun at any value; here they go on from what the log says last:
///     t_log = t_live + (t_log_end - t_live_first)
///     T_odom_base = T_odom_base_log_end * T_live_base_first^-1 * T_live_base
/// The covariance is that of the log's end, moved along, plus the live robot's. What odometry does not see
/// is not in it: how far the robot rolled after the log's last state, and whether somebody has pushed it.
/// Scan where it stands, and register, before trusting the pose.
class ContinuedRobot : public Robot {
 public:
  /// Keeps a reference. Asks the live robot where and when it is.
  ContinuedRobot(Robot& live, const LastKnown& log_end);

  double Now() const override { return live_.Now() + time_offset_; }
  slam::Pose3 T_base_laser() const override { return live_.T_base_laser(); }
  slam::Scan TakeScan() override;
  slam::LaserSweep TakeSweep() override;
  std::vector<SafetySweep> TakeSafetySweeps() override;
  RobotState State() override;
  void Drive(const Velocity& velocity) override { live_.Drive(velocity); }
  /// Now() is not before `time` then, in spite of rounding.
  void WaitUntil(double time) override;

 private:
  slam::Odometry Continued(const slam::Odometry& live) const;

  Robot& live_;
  double time_offset_ = 0.0;  // [s]
  slam::Odometry log_end_;
  slam::Pose2 T_first_live_;  // from the live odometry's frame to where the robot first stood
};

}  // namespace ariadne::drivers
