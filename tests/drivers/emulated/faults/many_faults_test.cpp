#include <gtest/gtest.h>

#include "tests/drivers/emulated/lms200_faults.h"

namespace ariadne::drivers {
namespace {

/// 10^4 faults on streams of all variants: no sweep with a wrong range or a wrong time, and sweeps again
/// within 5 s of each.
TEST(ManyFaults, NeverMakeAWrongRange) {
  int faults = 0;
  int sweeps = 0;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const FaultCount count = SurviveFaults(seed, 1000);
    faults += count.faults;
    sweeps += count.sweeps;
    if (HasFailure()) break;
  }
  EXPECT_EQ(faults, 10000);
  RecordProperty("sweeps", sweeps);
}

}  // namespace
}  // namespace ariadne::drivers
