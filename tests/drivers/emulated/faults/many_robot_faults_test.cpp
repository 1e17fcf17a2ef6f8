#include "tests/drivers/emulated/robot/robot_faults.h"

namespace ariadne::drivers {
namespace {

/// 10^4 faults on all lines of a robot while it takes 3D scans: no wrong point in any scan.
TEST(ManyFaults, NeverMakeAWrongScan) {
  ScansWithFaults all;
  for (std::uint64_t seed = 0; seed < 10 && !HasFailure(); ++seed) {
    const ScansWithFaults count = ScanWithFaults(seed, 1000);
    all.faults += count.faults;
    all.scans += count.scans;
    all.repeated += count.repeated;
    all.sentences += count.sentences;
  }
  EXPECT_GE(all.faults, 10000);
  EXPECT_GT(all.scans, 100);
  RecordProperty("scans", all.scans);
  RecordProperty("repeated", all.repeated);
  RecordProperty("sentences", all.sentences);
}

}  // namespace
}  // namespace ariadne::drivers
