#include "drivers/replay/log_cursor.h"

#include <cmath>

namespace ariadne::drivers {
namespace {

double EndOf(const slam::LaserSweep& sweep, const slam::ScannerModel& scanner) {
  return sweep.stamp + scanner.turn_period * scanner.turns_per_sweep;
}

}  // namespace

void LogCursor::Pass(const RobotCall& call) {
  ++position_;
  if (const auto* now = std::get_if<NowCall>(&call)) NoteTime(now->time);
  if (const auto* wait = std::get_if<WaitCall>(&call)) NoteTime(wait->until);
  if (const auto* sweep = std::get_if<SweepCall>(&call)) NoteTime(sweep->sweep.stamp);
  if (const auto* safety = std::get_if<SafetySweepsCall>(&call)) {
    for (const SafetySweep& sweep : safety->sweeps) NoteTime(EndOf(sweep.sweep, sweep.scanner));
  }
  if (const auto* state = std::get_if<StateCall>(&call)) {
    NoteTime(state->state.stamp);
    last_known_.odometry = state->state.odometry;
  }
  if (const auto* scan = std::get_if<ScanCall>(&call)) {
    if (!scan->scan.sweeps.empty()) NoteTime(EndOf(scan->scan.sweeps.back(), scan->scan.scanner));
    last_known_.odometry = scan->scan.odometry;
  }
}

void LogCursor::PassNotes() {
  while (AtNote()) ++position_;
}

void LogCursor::NoteTime(double time) {
  if (std::isfinite(time)) last_known_.time = std::max(time, last_known_.time.value_or(time));
}

}  // namespace ariadne::drivers
