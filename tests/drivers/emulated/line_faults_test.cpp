#include <gtest/gtest.h>

#include "tests/drivers/emulated/lms200_faults.h"

namespace ariadne::drivers {
namespace {

using Kind = LineFault::Kind;

/// Each kind of fault by itself, in mid-stream: no wrong sweep, and sweeps again within 5 s of its end.
TEST(LineFaults, AreSurvivedOneByOne) {
  RandomStream stream = NamedStream(1, "one by one");
  for (const double resolution : {1.0, 0.25}) {
    for (int kind = 0; kind < LineFault::kKinds; ++kind) {
      Lms200Bench bench(With(180, resolution));
      bench.driver->StartStream();
      for (int i = 0; i < 4; ++i) {
        LineFault fault = DrawFault(stream, bench.driver->Now(), bench.driver->Now() + 0.2);
        fault.kind = static_cast<Kind>(kind);
        fault.to_device = false;
        if (fault.kind == Kind::kFlip) fault.count = 1;
        if (fault.kind == Kind::kDead) fault.duration = 2.0;
        SCOPED_TRACE(testing::Message() << "kind " << kind << ", resolution " << resolution);
        ASSERT_TRUE(SurvivesFault(bench, fault));
      }
    }
  }
}

TEST(LineFaults, OfOneSeedNeverMakeAWrongRange) {
  const FaultCount count = SurviveFaults(7, 400);
  EXPECT_EQ(count.faults, 400);
  EXPECT_GT(count.sweeps, 1000);
}

}  // namespace
}  // namespace ariadne::drivers
