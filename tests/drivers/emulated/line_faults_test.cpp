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

TEST(LineFaults, NeverMakeAWrongRangeOnRequest) {
  RandomStream stream = NamedStream(3, "on request");
  for (const double resolution : {1.0, 0.5}) {
    Lms200Bench bench(With(180, resolution));
    bench.driver->Connect();
    for (int i = 0; i < 200; ++i) {
      const double now = bench.driver->Now();
      bench.line->Inject(DrawFault(stream, now, now + 0.05));
      const Lms200Sweep sweep = bench.driver->TakeSweep();
      ASSERT_TRUE(bench.IsRight(sweep, bench.driver->scanner().turns_per_sweep / 75.0 + 0.006)) << i;
      ASSERT_LT(bench.driver->Now(), now + 0.35 + 2.0 + 5.0);  // the fault, a boot, and 5 s
    }
  }
}

/// A line that returns after minutes finds the driver still asking, or gone with a sentence.
TEST(LineFaults, EndInASentenceWhereTheyDoNotEnd) {
  Lms200Options options = With(180, 1.0);
  options.recovery_time = 10.0;
  Lms200Bench bench(options);
  bench.driver->StartStream();
  LineFault dead;
  dead.kind = Kind::kDead;
  dead.time = bench.driver->Now();
  dead.duration = 60.0;
  bench.line->Inject(dead);
  try {
    while (true) bench.driver->NextSweep();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("see its power and its cable"), std::string::npos);
  }
  EXPECT_GT(bench.driver->Now(), dead.time + 10.0);
  EXPECT_LT(bench.driver->Now(), dead.time + 20.0);
}

}  // namespace
}  // namespace ariadne::drivers
