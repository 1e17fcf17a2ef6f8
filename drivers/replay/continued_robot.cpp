#include "drivers/replay/continued_robot.h"

#include <cmath>
#include <limits>

namespace ariadne::drivers {

ContinuedRobot::ContinuedRobot(Robot& live, const LastKnown& log_end) : live_(live) {
  const RobotState first = live.State();
  if (log_end.time) time_offset_ = *log_end.time - live.Now();
  log_end_.T_odom_base = first.odometry.T_odom_base;  // where the log does not know better
  if (log_end.odometry) log_end_ = *log_end.odometry;
  T_first_live_ = first.odometry.T_odom_base.Inverse();
}

slam::Scan ContinuedRobot::TakeScan() {
  slam::Scan scan = live_.TakeScan();
  scan.odometry = Continued(scan.odometry);
  for (slam::LaserSweep& sweep : scan.sweeps) sweep.stamp += time_offset_;
  return scan;
}

slam::LaserSweep ContinuedRobot::TakeSweep() {
  slam::LaserSweep sweep = live_.TakeSweep();
  sweep.stamp += time_offset_;
  return sweep;
}

std::vector<SafetySweep> ContinuedRobot::TakeSafetySweeps() {
  std::vector<SafetySweep> sweeps = live_.TakeSafetySweeps();
  for (SafetySweep& safety : sweeps) safety.sweep.stamp += time_offset_;
  return sweeps;
}

RobotState ContinuedRobot::State() {
  RobotState state = live_.State();
  state.stamp += time_offset_;
  state.odometry = Continued(state.odometry);
  return state;
}

void ContinuedRobot::WaitUntil(double time) {
  double live_time = time - time_offset_;
  while (live_time + time_offset_ < time) {
    live_time = std::nextafter(live_time, std::numeric_limits<double>::infinity());
  }
  live_.WaitUntil(live_time);
}

slam::Odometry ContinuedRobot::Continued(const slam::Odometry& live) const {
  const slam::Pose2 T_first_now = T_first_live_ * live.T_odom_base;
  const slam::Pose2::Square along = T_first_now.Inverse().Adjoint();
  return {log_end_.T_odom_base * T_first_now,
          along * log_end_.covariance * along.transpose() + live.covariance};
}

}  // namespace ariadne::drivers
