#pragma once

#include <optional>
#include <vector>

#include "drivers/emulated/line_fault.h"

namespace ariadne::drivers {

/// The faults of a line that have not happened yet, and what they do to its bytes.
class LineFaults {
 public:
  /// In any order.
  void Inject(const LineFault& fault) { faults_.push_back(fault); }
  std::size_t pending() const { return faults_.size(); }

  /// What arrives of a byte; each fault is used up by its last one.
  struct Passed {
    int copies = 1;
    std::uint8_t byte = 0;
    double delay = 0.0;  // of this byte and all after it [s]
  };
  Passed Pass(std::uint8_t byte, double time, bool to_device);

  /// When power is lost next [s]; infinity for never.
  double NextPowerLoss() const;
  /// One that is due.
  std::optional<LineFault> TakePowerLoss(double time);

 private:
  bool IsDead(double time) const;

  std::vector<LineFault> faults_;
};

}  // namespace ariadne::drivers
