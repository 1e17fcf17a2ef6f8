#include "drivers/hardware/dynamixel/servo.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "drivers/emulated/emulated_line.h"
#include "drivers/emulated/emulated_servo.h"
#include "tests/support/error_of.h"

namespace ariadne::drivers {
namespace {

using dynamixel::Servo;
using dynamixel::ServoOptions;
using dynamixel::ServoState;
using testing::HasSubstr;

struct ServoBench {
  explicit ServoBench(const ServoOptions& options = {}, const EmulatedServoOptions& device_options = {})
      : device(device_options) {
    auto owned = std::make_unique<EmulatedLine>(device);
    line = owned.get();
    servo = std::make_unique<Servo>(std::move(owned), options);
  }
  double TrueAngle() const { return (device.position() - 0.5) * 2.0 * std::numbers::pi; }

  EmulatedServo device;
  EmulatedLine* line = nullptr;
  std::unique_ptr<Servo> servo;
};

TEST(Servo, GoesWhereItIsSentAndSaysWhereItIs) {
  for (const bool echo : {false, true}) {
    EmulatedServoOptions device;
    device.echo = echo;
    ServoBench bench({}, device);
    bench.servo->Connect();
    EXPECT_EQ(bench.servo->model(), 1060);
    bench.servo->SetTorque(true);
    bench.servo->SetProfile(0.6, 3.0);
    for (const double angle : {1.0, -0.7, 0.0}) {
      bench.servo->MoveTo(angle);
      bench.servo->WaitFor(angle, 0.002, 5.0);
      EXPECT_NEAR(bench.TrueAngle(), angle, 0.002);
    }
    EXPECT_EQ(bench.servo->repeated(), 0U);
  }
}

/// A slice's pitch is what the servo measured: position and time belong together.
TEST(Servo, MeasuresWhileItMoves) {
  ServoBench bench;
  bench.servo->Connect();
  bench.servo->SetTorque(true);
  bench.servo->SetProfile(0.61, 100.0);
  bench.servo->MoveTo(-1.0);
  bench.servo->WaitFor(-1.0, 0.002, 5.0);
  bench.servo->MoveTo(1.0);
  DiscardUntil(*bench.line, bench.line->Now() + 0.3);
  const ServoState first = bench.servo->State();
  EXPECT_NEAR(first.velocity, 0.61, 0.02);
  DiscardUntil(*bench.line, bench.line->Now() + 1.0);
  const ServoState second = bench.servo->State();
  EXPECT_NEAR((second.angle - first.angle) / (second.time - first.time), first.velocity, 0.01);
}

TEST(Servo, TurnsTheOtherWayWhereItIsMountedSo) {
  ServoOptions options;
  options.reversed = true;
  ServoBench bench(options);
  bench.servo->Connect();
  bench.servo->SetTorque(true);
  bench.servo->MoveTo(0.5);
  bench.servo->WaitFor(0.5, 0.002, 5.0);
  EXPECT_NEAR(bench.TrueAngle(), -0.5, 0.002);
}

TEST(Servo, StaysWithinWhatTheMountBears) {
  ServoOptions options;
  options.max_angle = 0.8;
  ServoBench bench(options);
  bench.servo->Connect();
  bench.servo->SetTorque(true);
  EXPECT_THAT(ErrorOf([&] { bench.servo->MoveTo(0.9); }), HasSubstr("0.8"));
  EXPECT_THROW(bench.servo->MoveTo(std::nan("")), Error);
  EXPECT_THROW(bench.servo->SetProfile(0.0, 1.0), Error);
  EXPECT_NEAR(bench.TrueAngle(), 0.0, 1e-9);
}

TEST(Servo, SaysWhenItIsStuck) {
  ServoBench bench;
  bench.servo->Connect();
  bench.servo->SetTorque(true);
  bench.device.SetStuck(true);
  bench.servo->MoveTo(0.5);
  EXPECT_THAT(ErrorOf([&] { bench.servo->WaitFor(0.5, 0.01, 2.0); }), HasSubstr("what holds its mount"));
  EXPECT_EQ(bench.servo->HardwareError(), "overload");
  EXPECT_THAT(ErrorOf([&] { bench.servo->MoveTo(0.2); }), HasSubstr("overload"));
  EXPECT_THAT(ErrorOf([&] { bench.servo->Connect(); }), HasSubstr("overload"));
}

TEST(Servo, SaysWhenThereIsNone) {
  ServoOptions options;
  options.id = 7;
  ServoBench other_id(options);
  EXPECT_THAT(ErrorOf([&] { other_id.servo->Connect(); }), HasSubstr("servo 7"));
  options.id = 1;
  options.baud = 1000000;
  ServoBench other_rate(options);
  EXPECT_THAT(ErrorOf([&] { other_rate.servo->Connect(); }), HasSubstr("1000000 baud"));
}

/// No fault on the line makes a wrong angle; what is recoverable is recovered by asking again.
TEST(Servo, IsNeverWrongOverABadLine) {
  RandomStream stream = NamedStream(1, "servo faults");
  ServoBench bench;
  bench.servo->Connect();
  bench.servo->SetTorque(true);
  int answered = 0;
  for (int i = 0; i < 1000; ++i) {
    LineFault fault = DrawFault(stream, bench.line->Now(), bench.line->Now() + 0.01);
    if (fault.kind == LineFault::Kind::kPowerLoss) fault.kind = LineFault::Kind::kFlip;
    if (fault.kind == LineFault::Kind::kFlip) fault.count = 1;
    bench.line->Inject(fault);
    try {
      const ServoState state = bench.servo->State();
      ASSERT_NEAR(state.angle, bench.TrueAngle(), 0.001);
      ++answered;
    } catch (const Error& error) {
      ASSERT_THAT(error.what(), testing::AnyOf(HasSubstr("does not answer"), HasSubstr("reports")));
      DiscardUntil(*bench.line, bench.line->Now() + 0.4);
    }
  }
  EXPECT_GT(answered, 950);
}

}  // namespace
}  // namespace ariadne::drivers
