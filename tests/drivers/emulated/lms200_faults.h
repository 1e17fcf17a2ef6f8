#pragma once

#include "tests/drivers/emulated/lms200_bench.h"

namespace ariadne::drivers {

/// Takes sweeps until the fault is over and some have come again; each must be right, and the first one
/// after the fault within 5 s of its end (the boot of the device, after a loss of power).
inline testing::AssertionResult SurvivesFault(Lms200Bench& bench, const LineFault& fault,
                                              int* sweeps = nullptr) {
  bench.line->Inject(fault);
  double over = fault.time + fault.duration;
  if (fault.kind == LineFault::Kind::kPowerLoss) over += 2.0;
  for (int after = 0; after < 3;) {
    const double before = bench.driver->Now();
    const Lms200Sweep sweep = bench.driver->NextSweep();
    if (sweeps != nullptr) ++*sweeps;
    if (testing::AssertionResult right = bench.IsRight(sweep); !right) {
      return right << ", fault of kind " << static_cast<int>(fault.kind) << " at " << fault.time
                   << ", count " << fault.count << ", duration " << fault.duration;
    }
    if (sweep.sweep.stamp > over) ++after;
    const double since = bench.driver->Now() - std::max(over, before);
    if (since > 5.0) {
      return testing::AssertionFailure() << "no sweep for " << since << " s after a fault of kind "
                                         << static_cast<int>(fault.kind) << " at " << fault.time;
    }
  }
  return testing::AssertionSuccess();
}

struct FaultCount {
  int faults = 0;
  int sweeps = 0;
};

/// So many faults of all kinds, on streams of all variants, 50 to a scanner.
inline FaultCount SurviveFaults(std::uint64_t seed, int faults) {
  FaultCount count;
  RandomStream stream = NamedStream(seed, "line faults");
  const std::vector<std::pair<int, double>> variants = {{180, 1.0}, {180, 0.5}, {180, 0.25}, {100, 0.25}};
  while (count.faults < faults) {
    const auto& [field_of_view, resolution] = variants[stream() % variants.size()];
    EmulatedLms200Options device;
    device.strict = stream() % 2 == 0;
    device.reply_at_new_baud = stream() % 2 == 0;
    Lms200Bench bench(With(field_of_view, resolution), device);
    bench.driver->StartStream();
    for (int i = 0; i < 50 && count.faults < faults; ++i, ++count.faults) {
      const double now = bench.driver->Now();
      const testing::AssertionResult survived =
          SurvivesFault(bench, DrawFault(stream, now, now + 0.2), &count.sweeps);
      EXPECT_TRUE(survived) << "seed " << seed << ", fault " << count.faults;
      if (!survived) return count;
    }
  }
  return count;
}

}  // namespace ariadne::drivers
