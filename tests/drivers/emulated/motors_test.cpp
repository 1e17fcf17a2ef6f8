#include "drivers/hardware/roboclaw/motors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "drivers/emulated/emulated_line.h"
#include "drivers/emulated/emulated_motors.h"
#include "tests/support/error_of.h"

namespace ariadne::drivers {
namespace {

using roboclaw::EncoderCounts;
using roboclaw::Motors;
using roboclaw::MotorsOptions;
using testing::HasSubstr;

struct MotorsBench {
  explicit MotorsBench(const MotorsOptions& options = {}) {
    auto owned = std::make_unique<EmulatedLine>(device);
    line = owned.get();
    motors = std::make_unique<Motors>(std::move(owned), options);
  }
  /// Lets time pass without a command.
  void Wait(double seconds) { DiscardUntil(*line, line->Now() + seconds); }

  EmulatedMotors device;
  EmulatedLine* line = nullptr;
  std::unique_ptr<Motors> motors;
};

TEST(Motors, TurnAsTheyAreTold) {
  MotorsBench bench;
  bench.motors->Connect();
  EXPECT_THAT(bench.motors->version(), HasSubstr("Roboclaw"));
  bench.motors->SetSpeeds({1000.0, -500.0}, 10000.0);
  for (int i = 0; i < 10; ++i) {
    bench.Wait(0.05);
    bench.motors->Encoders();  // keeps the timeout from running out
  }
  EXPECT_EQ(bench.motors->MeasuredSpeeds(), (roboclaw::Pair{1000.0, -500.0}));
  const EncoderCounts first = bench.motors->Encoders();
  bench.Wait(0.1);
  const EncoderCounts second = bench.motors->Encoders();
  const double seconds = second.time - first.time;
  EXPECT_NEAR(second.counts[0] - first.counts[0], 1000.0 * seconds, 2.0);
  EXPECT_NEAR(second.counts[1] - first.counts[1], -500.0 * seconds, 2.0);
  EXPECT_NEAR(bench.motors->Currents()[1], -0.4, 1e-9);
  EXPECT_NEAR(bench.motors->Battery(), 24.4, 1e-9);
  bench.motors->Stop();
  bench.Wait(0.01);
  EXPECT_EQ(bench.device.speeds(), (std::array<double, 2>{0.0, 0.0}));
}

/// A program that dies: the board stops by itself at its timeout, and 50 ms of braking later the wheels
/// stand.
TEST(Motors, StopWhenNobodyTalksToThem) {
  MotorsOptions options;
  options.timeout = 0.3;
  MotorsBench bench(options);
  bench.motors->Connect();
  bench.motors->SetSpeeds({1000.0, 1000.0}, 100000.0);
  const double told = bench.line->Now();
  bench.Wait(0.25);
  EXPECT_EQ(bench.device.speeds()[0], 1000.0);
  DiscardUntil(*bench.line, told + 0.3 + 0.1);
  EXPECT_EQ(bench.device.speeds()[0], 0.0);
  const double position = bench.device.positions()[0];
  bench.Wait(1.0);
  EXPECT_EQ(bench.device.positions()[0], position);
}

/// The board forgets its timeout and its counts without power; no wheel turns before somebody knows.
TEST(Motors, SayWhenTheyWereWithoutPower) {
  MotorsBench bench;
  bench.motors->Connect();
  bench.motors->SetSpeeds({1000.0, 1000.0}, 100000.0);
  bench.Wait(0.1);
  EXPECT_GT(bench.motors->Encoders().counts[0], 50);
  for (const bool counts : {false, true}) {
    bench.device.LosePower(bench.line->Now(), 0.05);
    bench.Wait(0.1);
    const auto call = [&] {
      if (counts) {
        bench.motors->Encoders();
      } else {
        bench.motors->SetSpeeds({1000.0, 1000.0}, 100000.0);
      }
    };
    EXPECT_THAT(ErrorOf(call), HasSubstr("without power"));
    EXPECT_EQ(bench.device.speeds()[0], 0.0);
    EXPECT_EQ(bench.motors->Encoders().counts[0], 0);  // said once
  }
  bench.motors->SetSpeeds({1000.0, 1000.0}, 100000.0);
  bench.Wait(0.1);
  EXPECT_EQ(bench.device.speeds()[0], 1000.0);
  bench.Wait(0.3);
  EXPECT_EQ(bench.device.speeds()[0], 0.0);  // the timeout is there again
}

TEST(Motors, CountAcrossTheWrap) {
  constexpr std::int32_t kLargest = std::numeric_limits<std::int32_t>::max();
  EXPECT_EQ(roboclaw::CountsBetween(kLargest - 4, std::numeric_limits<std::int32_t>::min() + 5), 10);
  EXPECT_EQ(roboclaw::CountsBetween(3, -4), -7);
}

TEST(Motors, AreNotSentBeyondTheirLimits) {
  MotorsOptions options;
  options.max_speed = 2000.0;
  MotorsBench bench(options);
  bench.motors->Connect();
  EXPECT_THAT(ErrorOf([&] { bench.motors->SetSpeeds({2001.0, 0.0}, 1.0); }), HasSubstr("2000"));
  EXPECT_THROW(bench.motors->SetSpeeds({std::nan(""), 0.0}, 1.0), Error);
  EXPECT_THROW(bench.motors->SetSpeeds({0.0, 0.0}, 0.0), Error);
}

TEST(Motors, SayWhatIsWrong) {
  MotorsBench bench;
  bench.motors->Connect();
  EXPECT_EQ(bench.motors->Warnings(), "");
  bench.device.SetStatus(0x0804);
  EXPECT_EQ(bench.motors->Warnings(), "emergency stop, main battery rather low");
  bench.device.SetBlocked(0, true);
  bench.motors->SetSpeeds({500.0, 500.0}, 10000.0);
  bench.Wait(0.1);
  EXPECT_NEAR(bench.motors->Currents()[0], 9.0, 1e-9);
  EXPECT_EQ(bench.motors->MeasuredSpeeds()[0], 0.0);
  MotorsOptions options;
  options.address = 0x81;
  MotorsBench other(options);
  EXPECT_THAT(ErrorOf([&] { other.motors->Connect(); }), HasSubstr("address 129"));
}

/// A board that is held up for 80 ms again and again, as an emulated one is on a loaded machine.
TEST(Motors, GoOnAfterLateAnswers) {
  RandomStream stream = NamedStream(1, "late motors");
  MotorsBench bench;
  bench.motors->Connect();
  int late = 0;
  for (int i = 0; i < 500; ++i) {
    LineFault held;
    held.kind = LineFault::Kind::kDelay;
    held.time = bench.line->Now() + DrawUniform(stream, 0.0, 0.04);
    held.duration = DrawUniform(stream, 0.03, 0.12);
    bench.line->Inject(held);
    const double speed = i % 2 == 0 ? 500.0 : -800.0;
    if (!bench.motors->SetSpeeds({speed, speed}, 1e9)) {
      ++late;
      EXPECT_FALSE(bench.motors->turning());
      EXPECT_EQ(bench.device.speeds()[0], 0.0) << i;
      continue;
    }
    EXPECT_EQ(bench.device.speeds()[0], speed) << i;
    bench.motors->Encoders();
    EXPECT_EQ(bench.device.speeds()[0], bench.motors->turning() ? speed : 0.0) << i;
  }
  EXPECT_GT(bench.motors->repeated(), 100U);
  EXPECT_LT(late, 250);
}

/// A line on which nothing comes back from some time on.
struct MutedLine : ByteStream {
  explicit MutedLine(EmulatedDevice& device) : line(device) {}
  std::string name() const override { return line.name(); }
  double Now() const override { return line.Now(); }
  Bytes Read(double deadline) override {
    if (!muted) return line.Read(deadline);
    line.Read(line.Now());
    while (line.Now() < deadline) line.Read(deadline);
    return {};
  }
  void Write(ByteView bytes) override { line.Write(bytes); }
  void SetBaud(int baud) override { line.SetBaud(baud); }
  int baud() const override { return line.baud(); }

  EmulatedLine line;
  bool muted = false;
};

/// The board hears each question, which puts off its own timeout; so the driver must stop the wheels.
TEST(Motors, AreStoppedWithinATenthOfASecondOfSilence) {
  EmulatedMotors device;
  auto owned = std::make_unique<MutedLine>(device);
  MutedLine& line = *owned;
  MotorsOptions options;
  options.timeout = 2.0;
  options.recovery_time = 0.14;
  Motors motors(std::move(owned), options);
  motors.Connect();
  ASSERT_TRUE(motors.SetSpeeds({1000.0, 1000.0}, 1e9));
  line.muted = true;
  const double silent = line.Now();
  EXPECT_THAT(ErrorOf([&] { motors.Encoders(); }), HasSubstr("does not answer"));
  EXPECT_LT(line.Now(), silent + 0.2);
  EXPECT_EQ(device.speeds()[0], 0.0);
  EXPECT_FALSE(motors.turning());
  EXPECT_NEAR(device.positions()[0], 1000.0 * 0.1, 1000.0 * 0.02) << "it turned for 0.1 s";
  line.muted = false;
  EXPECT_TRUE(motors.SetSpeeds({1000.0, 1000.0}, 1e9));
  EXPECT_EQ(device.speeds()[0], 1000.0);
}

/// No fault on the line makes wrong counts or a wrong speed.
TEST(Motors, AreNeverWrongOverABadLine) {
  RandomStream stream = NamedStream(1, "motor faults");
  MotorsBench bench;
  bench.motors->Connect();
  int answered = 0;
  for (int i = 0; i < 1000; ++i) {
    LineFault fault = DrawFault(stream, bench.line->Now(), bench.line->Now() + 0.01);
    if (fault.kind == LineFault::Kind::kPowerLoss) fault.kind = LineFault::Kind::kFlip;
    if (fault.kind == LineFault::Kind::kFlip) fault.count = 1;
    bench.line->Inject(fault);
    const double speed = 100.0 * static_cast<double>(stream() % 20) - 1000.0;
    const double position = bench.device.positions()[0];
    try {
      bench.motors->SetSpeeds({speed, speed}, 1e9);
      const EncoderCounts counts = bench.motors->Encoders();
      const double now = bench.device.positions()[0];
      ASSERT_GE(counts.counts[0], std::min(position, now) - 110.0) << i;  // it turned on meanwhile
      ASSERT_LE(counts.counts[0], std::max(position, now) + 110.0) << i;
      const double turns = bench.device.speeds()[0];  // as told, or stopping at the timeout
      ASSERT_TRUE(std::abs(turns) <= std::abs(speed) && turns * speed >= 0.0) << i;
      ++answered;
    } catch (const Error& error) {
      ASSERT_THAT(error.what(), HasSubstr("does not answer"));
      bench.Wait(0.4);
    }
  }
  EXPECT_GT(answered, 800);  // speeds are given up while a fault outlasts the timeout
}

}  // namespace
}  // namespace ariadne::drivers
