#pragma once

#include <functional>

#include "drivers/robot.h"

namespace ariadne::experiments {

/// A robot with a log until its mission is told to stop, and without from then on: how a mission ends (it
/// brakes, and asks for the time) is no part of it, and a resumed one, which does not end there, must not
/// find that on the log.
class UnloggedEnd : public drivers::Robot {
 public:
  /// Keeps references. `logged` puts on the log what `living` answers.
  UnloggedEnd(drivers::Robot& logged, drivers::Robot& living) : logged_(logged), living_(living) {}

  /// What to ask whether to stop; once it was true it remains so.
  std::function<bool()> Latched(std::function<bool()> stop);

  double Now() const override { return Active().Now(); }
  slam::Pose3 T_base_laser() const override { return Active().T_base_laser(); }
  slam::Scan TakeScan() override { return Active().TakeScan(); }
  slam::LaserSweep TakeSweep() override { return Active().TakeSweep(); }
  std::vector<drivers::SafetySweep> TakeSafetySweeps() override { return Active().TakeSafetySweeps(); }
  drivers::RobotState State() override { return Active().State(); }
  void Drive(const drivers::Velocity& velocity) override { Active().Drive(velocity); }
  void WaitUntil(double time) override { Active().WaitUntil(time); }

 private:
  drivers::Robot& Active() const { return stopped_ ? living_ : logged_; }

  drivers::Robot& logged_;
  drivers::Robot& living_;
  bool stopped_ = false;
};

inline std::function<bool()> UnloggedEnd::Latched(std::function<bool()> stop) {
  return [this, stop = std::move(stop)] {
    stopped_ = stopped_ || (stop && stop());
    return stopped_;
  };
}

}  // namespace ariadne::experiments
