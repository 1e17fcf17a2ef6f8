#include "drivers/replay/logged_robot.h"

#include <utility>

namespace ariadne::drivers {
namespace {

struct MakeOn {
  Robot& robot;

  void operator()(NowCall& call) const { call.time = robot.Now(); }
  void operator()(MountingCall& call) const { call.T_base_laser = robot.T_base_laser(); }
  void operator()(ScanCall& call) const { call.scan = robot.TakeScan(); }
  void operator()(SweepCall& call) const { call.sweep = robot.TakeSweep(); }
  void operator()(SafetySweepsCall& call) const { call.sweeps = robot.TakeSafetySweeps(); }
  void operator()(StateCall& call) const { call.state = robot.State(); }
  void operator()(const DriveCall& call) const { robot.Drive(call.velocity); }
  void operator()(const WaitCall& call) const { robot.WaitUntil(call.until); }
  void operator()(const Note& /*no call*/) const {}
};

}  // namespace

RobotCall MadeCall(Robot& robot, RobotCall asked) {
  std::visit(MakeOn{robot}, asked);
  return asked;
}

template <typename Call>
Call LoggedRobot::Answered(Call asked) const {
  return std::get<Call>(Answer(RobotCall(std::move(asked))));
}

double LoggedRobot::Now() const { return Answered(NowCall{}).time; }
slam::Pose3 LoggedRobot::T_base_laser() const { return Answered(MountingCall{}).T_base_laser; }
slam::Scan LoggedRobot::TakeScan() { return Answered(ScanCall{}).scan; }
slam::LaserSweep LoggedRobot::TakeSweep() { return Answered(SweepCall{}).sweep; }
std::vector<SafetySweep> LoggedRobot::TakeSafetySweeps() { return Answered(SafetySweepsCall{}).sweeps; }
RobotState LoggedRobot::State() { return Answered(StateCall{}).state; }
void LoggedRobot::Drive(const Velocity& velocity) { Answered(DriveCall{velocity}); }
void LoggedRobot::WaitUntil(double time) { Answered(WaitCall{time}); }

}  // namespace ariadne::drivers
