#include "drivers/replay/compared_robot.h"

#include <fmt/format.h>

#include <utility>

#include "drivers/replay/call_bytes.h"

namespace ariadne::drivers {

void ComparedRobot::FailDiffering(const RobotCall& recorded, const std::string& now) const {
  throw DepartedFromLog(fmt::format("{}: call {} ({:.3f} s) was recorded as {}; now {}", cursor_.name(),
                                    cursor_.position() + 1, cursor_.last_known().time.value_or(0.0),
                                    Describe(recorded), now));
}

/// `make` makes the call, with its answer.
template <typename Call, typename Make>
Call ComparedRobot::Compared(const Call& asked, const Make& make) const {
  if (cursor_.left() == 0) return make();
  const RobotCall recorded = cursor_.Peek();
  if (!AskTheSame(asked, recorded)) FailDiffering(recorded, Describe(asked));
  Call made = make();
  const RobotCall answered = made;
  if (EncodeCall(answered) != EncodeCall(recorded)) FailDiffering(recorded, "it has another answer");
  cursor_.Pass(recorded);
  return made;
}

double ComparedRobot::Now() const {
  return Compared(NowCall{}, [this] { return NowCall{robot_.Now()}; }).time;
}

slam::Pose3 ComparedRobot::T_base_laser() const {
  return Compared(MountingCall{}, [this] { return MountingCall{robot_.T_base_laser()}; }).T_base_laser;
}

slam::Scan ComparedRobot::TakeScan() {
  return Compared(ScanCall{}, [this] { return ScanCall{robot_.TakeScan()}; }).scan;
}

slam::LaserSweep ComparedRobot::TakeSweep() {
  return Compared(SweepCall{}, [this] { return SweepCall{robot_.TakeSweep()}; }).sweep;
}

std::vector<SafetySweep> ComparedRobot::TakeSafetySweeps() {
  return Compared(SafetySweepsCall{}, [this] { return SafetySweepsCall{robot_.TakeSafetySweeps()}; })
      .sweeps;
}

RobotState ComparedRobot::State() {
  return Compared(StateCall{}, [this] { return StateCall{robot_.State()}; }).state;
}

void ComparedRobot::Drive(const Velocity& velocity) {
  Compared(DriveCall{velocity}, [this, &velocity] {
    robot_.Drive(velocity);
    return DriveCall{velocity};
  });
}

void ComparedRobot::WaitUntil(double time) {
  Compared(WaitCall{time}, [this, time] {
    robot_.WaitUntil(time);
    return WaitCall{time};
  });
}

void ComparedRobot::Note(std::string_view text) {
  if (cursor_.left() == 0) return;
  const drivers::Note noted{std::string(text)};
  const RobotCall recorded = cursor_.Peek();
  const auto* note = std::get_if<drivers::Note>(&recorded);
  if (note == nullptr || note->text != noted.text) FailDiffering(recorded, Describe(noted));
  cursor_.PassNote();
}

}  // namespace ariadne::drivers
