#include "drivers/emulated/line_faults.h"

#include <algorithm>
#include <limits>

namespace ariadne::drivers {
namespace {

bool LastsLong(const LineFault& fault) { return fault.kind == LineFault::Kind::kDead; }

}  // namespace

bool LineFaults::IsDead(double time) const {
  return std::any_of(faults_.begin(), faults_.end(), [time](const LineFault& fault) {
    return LastsLong(fault) && time >= fault.time && time < fault.time + fault.duration;
  });
}

LineFaults::Passed LineFaults::Pass(std::uint8_t byte, double time, bool to_device) {
  Passed passed;
  passed.byte = byte;
  if (faults_.empty()) return passed;
  if (IsDead(time)) {
    passed.copies = 0;
    return passed;
  }
  for (LineFault& fault : faults_) {
    const bool other = LastsLong(fault) || fault.kind == LineFault::Kind::kPowerLoss;
    if (other || fault.to_device != to_device || fault.time > time) continue;
    if (fault.kind == LineFault::Kind::kDrop) passed.copies = 0;
    if (fault.kind == LineFault::Kind::kDuplicate) passed.copies = 2;
    if (fault.kind == LineFault::Kind::kFlip) passed.byte ^= static_cast<std::uint8_t>(1U << fault.bit);
    if (fault.kind == LineFault::Kind::kDelay) passed.delay = fault.duration;
    --fault.count;
    if (fault.kind == LineFault::Kind::kDelay) fault.count = 0;
  }
  std::erase_if(faults_, [time](const LineFault& fault) {
    return fault.count <= 0 || (LastsLong(fault) && fault.time + fault.duration <= time);
  });
  return passed;
}

double LineFaults::NextPowerLoss() const {
  double next = std::numeric_limits<double>::infinity();
  for (const LineFault& fault : faults_) {
    if (fault.kind == LineFault::Kind::kPowerLoss) next = std::min(next, fault.time);
  }
  return next;
}

std::optional<LineFault> LineFaults::TakePowerLoss(double time) {
  const auto due = std::find_if(faults_.begin(), faults_.end(), [time](const LineFault& fault) {
    return fault.kind == LineFault::Kind::kPowerLoss && fault.time <= time;
  });
  if (due == faults_.end()) return std::nullopt;
  const LineFault fault = *due;
  faults_.erase(due);
  return fault;
}

}  // namespace ariadne::drivers
