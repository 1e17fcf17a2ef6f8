#include "tests/drivers/emulated/robot/robot_faults.h"

namespace ariadne::drivers {
namespace {

TEST(HardwareRobot, TakesRightScansOverBadLinesOrSaysWhyNot) {
  const ScansWithFaults count = ScanWithFaults(1, 300);
  EXPECT_GT(count.scans, 5);
}

}  // namespace
}  // namespace ariadne::drivers
