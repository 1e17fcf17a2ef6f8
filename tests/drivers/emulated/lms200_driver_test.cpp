#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/drivers/emulated/lms200_bench.h"
#include "tests/support/error_of.h"

namespace ariadne::drivers {
namespace {

using testing::HasSubstr;

void ExpectRightSweeps(Lms200Bench& bench, int count) {
  bench.driver->StartStream();
  double previous = 0.0;
  for (int i = 0; i < count; ++i) {
    const Lms200Sweep sweep = bench.driver->NextSweep();
    ASSERT_EQ(sweep.sweep.ranges.size(), bench.driver->beams());
    ASSERT_TRUE(bench.IsRight(sweep));
    ASSERT_GT(sweep.sweep.stamp, previous);
    previous = sweep.sweep.stamp;
  }
}

TEST(Lms200Driver, StreamsEachVariantWithRightRangesAndTimes) {
  const std::vector<std::tuple<int, double, int, std::size_t>> variants = {
      {180, 1.0, 500000, 181}, {180, 0.5, 500000, 361},  {180, 0.25, 500000, 721}, {100, 1.0, 500000, 101},
      {100, 0.5, 500000, 201}, {100, 0.25, 500000, 401}, {180, 1.0, 38400, 181},   {180, 0.5, 38400, 361},
      {180, 0.5, 9600, 361},   {100, 1.0, 19200, 101}};
  for (const auto& [field_of_view, resolution, baud, beams] : variants) {
    SCOPED_TRACE(testing::Message() << field_of_view << " deg, " << resolution << " deg, " << baud);
    Lms200Bench bench(With(field_of_view, resolution, baud));
    EXPECT_EQ(bench.driver->beams(), beams);
    ExpectRightSweeps(bench, 30);
    const double first_angle = bench.driver->scanner().first_angle;  // 0 or 40 deg; a turn may be offset
    EXPECT_NEAR(bench.log.first_angles.back(), first_angle, beams == 721 ? 0.0132 : 1e-9);
    EXPECT_EQ(bench.driver->counters().recoveries, 0U);
    EXPECT_EQ(bench.driver->counters().link.bad_checksums, 0U);
  }
}

/// All 75 turns of a second, as the paper's 13 ms per slice need.
TEST(Lms200Driver, MissesNoSweepAt500000Baud) {
  for (const double resolution : {1.0, 0.5, 0.25}) {
    Lms200Bench bench(With(180, resolution));
    bench.driver->StartStream();
    const double first = bench.driver->NextSweep().sweep.stamp;
    const double duration = bench.driver->scanner().turns_per_sweep / 75.0;
    for (int i = 1; i <= 100; ++i) {
      EXPECT_NEAR(bench.driver->NextSweep().sweep.stamp, first + i * duration, 0.001);
    }
  }
}

/// An adapter hands over bytes up to its own period late, in step with the mirror or not.
TEST(Lms200Driver, KnowsTimesBetterThanItsAdapter) {
  for (const double adapter : {0.0, 0.001, 0.0017, 0.004}) {
    EmulatedLineOptions line;
    line.chunk_time = adapter;
    Lms200Bench bench(With(180, 1.0), {}, line);
    bench.driver->StartStream();
    for (int i = 0; i < 50; ++i) bench.driver->NextSweep();
    for (int i = 0; i < 300; ++i) ASSERT_TRUE(bench.IsRight(bench.driver->NextSweep(), 5e-5)) << adapter;
  }
}

TEST(Lms200Driver, FindsTheScannerAtAnyRate) {
  for (const int rate : lms200::kBaudRates) {
    for (const bool at_new : {false, true}) {
      EmulatedLms200Options options;
      options.reply_at_new_baud = at_new;
      Lms200Bench bench(With(180, 0.5, rate), options);
      bench.driver->Connect();
      EXPECT_EQ(bench.device.baud(), rate);
      Lms200Options other = With(180, 1.0, 38400);
      Lms200 second(std::make_unique<EmulatedLine>(bench.device), other);
      // The second line begins at time 0 and its end at 9600 baud; the device is further and at `rate`.
      second.Connect();
      EXPECT_EQ(bench.device.baud(), 38400);
      EXPECT_EQ(second.type(), "LMS200;30106x;V02.10");
    }
  }
}

TEST(Lms200Driver, TakesSweepsOnRequest) {
  for (const double resolution : {1.0, 0.5, 0.25}) {
    Lms200Bench bench(With(180, resolution));
    bench.driver->Connect();
    for (int i = 0; i < 5; ++i) {
      EXPECT_TRUE(bench.IsRight(bench.driver->TakeSweep())) << resolution << " deg, sweep " << i;
    }
  }
}

TEST(Lms200Driver, LeavesTheConfigurationAloneUnlessItMayChangeIt) {
  Lms200Options options = With(180, 1.0);
  options.millimetres = true;
  options.measuring_mode = 0x01;
  Lms200Bench bench(options);
  EXPECT_THAT(ErrorOf([&] { bench.driver->Connect(); }), HasSubstr("lms200.write_config=true"));
  EXPECT_EQ(bench.device.config_writes(), 0);
  options.write_config = true;
  for (const bool old : {false, true}) {
    EmulatedLms200Options device;
    device.old_config = old;
    Lms200Bench writing(options, device);
    ExpectRightSweeps(writing, 5);
    writing.driver->StopStream();
    writing.driver->Connect();
    EXPECT_EQ(writing.device.config_writes(), 1);  // and not once more
  }
}

TEST(Lms200Driver, ReadsReflectanceInEachWay) {
  for (const int mode : {0x01, 0x03, 0x05, 0x3F}) {
    Lms200Options options = With(180, 1.0);
    options.measuring_mode = mode;
    options.write_config = true;
    Lms200Bench bench(options);
    bench.driver->StartStream();
    const Lms200Sweep sweep = bench.driver->NextSweep();
    const slam::LaserSweep& truth = bench.log.At(sweep.sweep.stamp);
    const float step = mode == 0x01   ? 1.0F / 7.0F
                       : mode == 0x03 ? 1.0F / 3.0F
                       : mode == 0x05 ? 1.0F
                                      : 1.0F / 255.0F;
    ASSERT_EQ(sweep.sweep.reflectance.size(), 181U);
    for (std::size_t i = 0; i < 181; ++i) {
      EXPECT_NEAR(sweep.sweep.reflectance[i], truth.reflectance[i], 0.5F * step + 1e-6F) << mode;
      // An amplitude is no distance.
      EXPECT_TRUE(mode != 0x3F || std::isnan(sweep.sweep.ranges[i]));
    }
    EXPECT_TRUE(mode == 0x3F || bench.IsRight(sweep));
  }
}

TEST(Lms200Driver, ReadsReflectivityOfFastModelsOnly) {
  Lms200Options options = With(180, 1.0);
  options.reflectivity = true;
  EmulatedLms200Options device;
  device.s14 = true;
  Lms200Bench fast(options, device);
  fast.driver->StartStream();
  const Lms200Sweep sweep = fast.driver->NextSweep();
  EXPECT_TRUE(fast.IsRight(sweep));
  EXPECT_NEAR(sweep.sweep.reflectance[7], fast.log.At(sweep.sweep.stamp).reflectance[7],
              0.5F / 255.0F + 1e-6F);
  Lms200Bench slow(options);
  EXPECT_THAT(ErrorOf([&] { slow.driver->StartStream(); }), HasSubstr("refuses mode 0x50"));
}

/// A host that does not read for a while, or reads slowly, finds old sweeps in its buffer, perhaps not all
/// of them: each gets the time when it was taken, or none. The mirror is a little slower than it should be.
TEST(Lms200Driver, TakesNoOldSweepForANewOne) {
  for (const std::size_t buffer : {512U, 4096U, 65536U, 1U << 20U}) {
    for (const std::size_t read_size : {64U, 372U, 4096U}) {
      SCOPED_TRACE(testing::Message() << "buffer " << buffer << ", reads of " << read_size);
      EmulatedLms200Options slow;
      slow.turn_period *= 1.0005;
      EmulatedLineOptions host;
      host.buffer = buffer;
      host.read_size = read_size;
      Lms200Bench bench(With(180, 1.0), slow, host);
      bench.driver->StartStream();
      RandomStream stream = NamedStream(buffer + read_size, "slow host");
      int taken = 0;
      for (int pause = 0; pause < 40; ++pause) {
        bench.time->now += pause % 8 == 7 ? 60.0 : DrawUniform(stream, 0.0, 3.0);
        const double each = DrawUniform(stream, 0.0, 0.03);  // that the host spends on a sweep [s]
        const double until = bench.driver->Now() + 2.0;
        while (bench.driver->Now() < until) {
          const std::optional<Lms200Sweep> sweep = bench.driver->PollSweep(until);
          if (!sweep) break;
          ++taken;
          ASSERT_TRUE(bench.IsRight(*sweep, 0.0034)) << "pause " << pause;  // a quarter of a turn
          bench.time->now += each;
        }
      }
      EXPECT_GT(taken, 300);
      EXPECT_GT(bench.line->overrun(), 0U) << "a minute is 1.7 MB";
    }
  }
}

TEST(Lms200Driver, SaysWhatTheScannerSaysOfItself) {
  Lms200Bench bench(With(180, 1.0));
  bench.driver->StartStream();
  EXPECT_EQ(bench.driver->NextSweep().status, lms200::DeviceStatus{});
  bench.device.SetStatus(0x92);
  while (!bench.driver->NextSweep().status.polluted) {
  }
  EXPECT_EQ(bench.driver->NextSweep().status.severity, 2);
  bench.device.SetErrors({{3, 17}});
  bench.device.SetStatus(0x14);
  EXPECT_THAT(ErrorOf([&] {
                for (int i = 0; i < 3; ++i) bench.driver->NextSweep();
              }),
              testing::AllOf(HasSubstr("a fatal error"), HasSubstr("3/17")));
}

TEST(Lms200Driver, SaysWhenThereIsNoScanner) {
  Lms200Options options = With(180, 1.0);
  options.recovery_time = 5.0;
  Lms200Bench bench(options);
  LineFault dead;
  dead.kind = LineFault::Kind::kDead;
  dead.duration = 1e9;
  bench.line->Inject(dead);
  EXPECT_THAT(ErrorOf([&] { bench.driver->Connect(); }), HasSubstr("see its power and its cable"));
  EXPECT_LT(bench.driver->Now(), 8.0);
}

TEST(Lms200Driver, RefusesOptionsThatNoScannerHas) {
  EmulatedLms200 device({},
                        [](double, const slam::ScannerModel&, std::size_t) { return slam::LaserSweep{}; });
  const auto error_with = [&](const Lms200Options& options) {
    return ErrorOf([&] { Lms200(std::make_unique<EmulatedLine>(device), options); });
  };
  EXPECT_THAT(error_with(With(150, 1.0)), HasSubstr("100 or 180"));
  EXPECT_THAT(error_with(With(180, 0.3)), HasSubstr("1, 0.5 or 0.25"));
  EXPECT_THAT(error_with(With(180, 0.25, 38400)), HasSubstr("500000"));
  EXPECT_THAT(error_with(With(180, 0.5, 115200)), HasSubstr("115200"));
  Lms200Options options = With(180, 0.5);
  options.reflectivity = true;
  EXPECT_THAT(error_with(options), HasSubstr("lms200.reflectivity"));
}

}  // namespace
}  // namespace ariadne::drivers
