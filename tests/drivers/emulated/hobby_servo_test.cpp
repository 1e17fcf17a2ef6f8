#include "drivers/hardware/hobby_servo/hobby_servo.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "drivers/emulated/emulated_hobby_servo.h"
#include "drivers/emulated/emulated_line.h"
#include "tests/support/error_of.h"

namespace ariadne::drivers {
namespace {

using hobby_servo::HobbyServo;
using hobby_servo::HobbyServoOptions;
using testing::HasSubstr;

struct HobbyBench {
  explicit HobbyBench(const HobbyServoOptions& options = {}) : servo_options(options) {
    auto owned = std::make_unique<EmulatedLine>(device);
    line = owned.get();
    servo = std::make_unique<HobbyServo>(std::move(owned), options);
  }
  double TrueAngle() const { return (device.position() - servo_options.zero) / servo_options.per_radian; }

  HobbyServoOptions servo_options;
  EmulatedHobbyServo device;
  EmulatedLine* line = nullptr;
  std::unique_ptr<HobbyServo> servo;
};

TEST(HobbyServo, GoesWhereItIsSent) {
  HobbyBench bench;
  bench.servo->Connect();
  EXPECT_EQ(bench.device.pulse(), 0.0);  // limp until it is sent somewhere
  bench.servo->SetProfile(0.6, 3.0);
  for (const double angle : {0.0, 1.0, -0.7}) {
    bench.servo->MoveTo(angle);
    bench.servo->WaitFor(angle, 5.0);
    EXPECT_NEAR(bench.TrueAngle(), angle, 0.001);
    EXPECT_NEAR(bench.servo->State().angle, angle, 0.0005);
  }
  EXPECT_EQ(bench.servo->repeated(), 0U);
  bench.servo->Release();
  DiscardUntil(*bench.line, bench.line->Now() + 0.1);
  EXPECT_EQ(bench.device.pulse(), 0.0);
  EXPECT_THAT(ErrorOf([&] { bench.servo->State(); }), HasSubstr("no pulses"));
}

/// At the speed that it is told, and behind its pulse by its lag.
TEST(HobbyServo, MovesEvenly) {
  HobbyBench bench;
  bench.servo->Connect();
  bench.servo->SetProfile(0.61, 100.0);
  bench.servo->MoveTo(-1.0);
  bench.servo->WaitFor(-1.0, 5.0);
  bench.servo->MoveTo(1.0);
  DiscardUntil(*bench.line, bench.line->Now() + 0.5);
  const hobby_servo::CommandedState first = bench.servo->State();
  const double true_first = bench.TrueAngle();
  DiscardUntil(*bench.line, bench.line->Now() + 1.0);
  const hobby_servo::CommandedState second = bench.servo->State();
  EXPECT_NEAR((second.angle - first.angle) / (second.time - first.time), 0.61, 0.03);
  EXPECT_NEAR(first.angle - true_first, 0.61 * 0.03, 0.012);
}

TEST(HobbyServo, TurnsTheOtherWayWhereItIsMountedSo) {
  HobbyServoOptions options;
  options.reversed = true;
  HobbyBench bench(options);
  bench.servo->Connect();
  bench.servo->MoveTo(0.5);
  bench.servo->WaitFor(0.5, 5.0);
  EXPECT_NEAR(bench.TrueAngle(), -0.5, 0.001);
  EXPECT_NEAR(bench.servo->State().angle, 0.5, 0.001);
}

TEST(HobbyServo, StaysWithinItsLimits) {
  HobbyServoOptions options;
  options.max_angle = 0.8;
  options.min_pulse = 1100.0;
  HobbyBench bench(options);
  bench.servo->Connect();
  EXPECT_THAT(ErrorOf([&] { bench.servo->MoveTo(0.9); }), HasSubstr("0.8"));
  EXPECT_THAT(ErrorOf([&] { bench.servo->MoveTo(-0.7); }), HasSubstr("1100"));
  EXPECT_THROW(bench.servo->MoveTo(std::nan("")), Error);
  EXPECT_THROW(bench.servo->SetProfile(0.0, 1.0), Error);
  EXPECT_EQ(bench.device.pulse(), 0.0);
}

TEST(HobbyServo, SaysWhenThereIsNone) {
  HobbyServoOptions options;
  options.baud = 19200;
  HobbyBench bench(options);
  EXPECT_THAT(ErrorOf([&] { bench.servo->Connect(); }), HasSubstr("does not answer at 19200 baud"));
}

/// A controller that was without power sends no pulse, which it cannot say by itself.
TEST(HobbyServo, NoticesThatItsControllerWasReset) {
  HobbyBench bench;
  bench.servo->Connect();
  bench.servo->MoveTo(0.3);
  bench.servo->WaitFor(0.3, 5.0);
  bench.device.LosePower(bench.line->Now(), 0.05);
  DiscardUntil(*bench.line, bench.line->Now() + 0.1);
  EXPECT_THROW(bench.servo->State(), Error);
}

/// Replies have no checksum; what cannot be where the servo is sent is not believed.
TEST(HobbyServo, IsNotMisledOnABadLine) {
  RandomStream stream = NamedStream(1, "hobby faults");
  HobbyBench bench;
  bench.servo->Connect();
  bench.servo->MoveTo(0.2);
  bench.servo->WaitFor(0.2, 5.0);
  int answered = 0;
  for (int i = 0; i < 500; ++i) {
    LineFault fault = DrawFault(stream, bench.line->Now(), bench.line->Now() + 0.005);
    if (fault.kind == LineFault::Kind::kPowerLoss) fault.kind = LineFault::Kind::kFlip;
    if (fault.kind == LineFault::Kind::kFlip) fault.count = 1;
    bench.line->Inject(fault);
    try {
      ASSERT_NEAR(bench.servo->State().angle, 0.2, 0.0008) << i;
      ++answered;
    } catch (const Error& error) {
      ASSERT_THAT(error.what(), HasSubstr("does not answer"));
      DiscardUntil(*bench.line, bench.line->Now() + 0.4);
    }
  }
  EXPECT_GT(answered, 450);
}

}  // namespace
}  // namespace ariadne::drivers
