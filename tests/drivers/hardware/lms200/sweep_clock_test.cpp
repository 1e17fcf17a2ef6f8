#include "drivers/hardware/lms200/sweep_clock.h"

#include <gtest/gtest.h>

#include <cmath>

#include "slam/base/random.h"

namespace ariadne::drivers::lms200 {
namespace {

constexpr double kPeriod = 1.0 / 75.0;

TEST(SweepClock, FollowsTheMirrorAndNotTheArrivals) {
  RandomStream stream = NamedStream(1, "jitter");
  SweepClock clock(kPeriod);
  int timed = 0;
  for (int turn = 0; turn < 1000; ++turn) {
    const double end = 5.0 + turn * kPeriod;
    const std::optional<double> told = clock.EndOf(end + DrawUniform(stream, 0.0, 0.003));
    if (!told || turn < 50) continue;
    ++timed;
    EXPECT_NEAR(*told, end, 0.0008);  // of arrivals up to 3 ms late
  }
  EXPECT_EQ(timed, 950);
}

TEST(SweepClock, FollowsAMirrorThatIsNotQuiteNominal) {
  for (const double factor : {0.9995, 1.0005}) {
    SweepClock clock(kPeriod);
    for (int turn = 0; turn < 5000; ++turn) {
      const double end = turn * kPeriod * factor;
      const std::optional<double> told = clock.EndOf(end);
      if (turn >= 2) {
        ASSERT_TRUE(told) << turn;
        ASSERT_NEAR(*told, end, 1e-4);
      }
    }
  }
}

TEST(SweepClock, KnowsLinesThatLeaveSweepsOut) {
  SweepClock clock(kPeriod);
  for (int i = 0; i < 100; ++i) {
    const double end = i * 8 * kPeriod;
    const std::optional<double> told = clock.EndOf(end);
    EXPECT_EQ(told.has_value(), i >= 2);
    if (told) {
      EXPECT_NEAR(*told, end, 1e-9);
    }
  }
}

TEST(SweepClock, HasNoTimeForWhatWasHeldBack) {
  SweepClock clock(kPeriod);
  for (int turn = 0; turn < 10; ++turn) clock.EndOf(turn * kPeriod);
  // Turns 10 to 19 arrive at once with turn 20.
  for (int turn = 10; turn <= 19; ++turn) EXPECT_FALSE(clock.EndOf(19.7 * kPeriod));
  int lost = 0;
  for (int turn = 20; turn < 30; ++turn) {
    const std::optional<double> told = clock.EndOf(turn * kPeriod);
    if (!told) ++lost;
    if (told) {
      EXPECT_NEAR(*told, turn * kPeriod, 1e-9);
    }
  }
  EXPECT_EQ(lost, 0);  // as none is missing
}

TEST(SweepClock, WaitsForOthersToAgreeAfterALoss) {
  SweepClock clock(kPeriod);
  for (int turn = 0; turn < 10; ++turn) clock.EndOf(turn * kPeriod);
  for (int turn = 13; turn < 30; ++turn) {
    const std::optional<double> told = clock.EndOf(turn * kPeriod);
    EXPECT_EQ(told.has_value(), turn >= 15) << turn;
  }
}

/// Whatever is held back for how long, a time that is told is right to the jitter.
TEST(SweepClock, IsNeverWrongByMoreThanTheJitter) {
  RandomStream stream = NamedStream(2, "held back");
  for (int round = 0; round < 300; ++round) {
    SweepClock clock(kPeriod);
    double held_until = 0.0;
    int told = 0;
    for (int turn = 0; turn < 200; ++turn) {
      const double end = turn * kPeriod;
      if (stream() % 30 == 0) held_until = end + DrawUniform(stream, 0.0, 0.2);
      if (stream() % 30 == 0) continue;  // lost
      const double arrived = std::max(end, held_until) + DrawUniform(stream, 0.0, 0.001);
      const std::optional<double> time = clock.EndOf(arrived);
      if (!time) continue;
      ++told;
      ASSERT_NEAR(*time, end, 0.0012) << "round " << round << ", turn " << turn;
    }
    EXPECT_GT(told, 30);
  }
}

TEST(SweepClock, TakesUpTheBeatOfADeviceThatWasReset) {
  SweepClock clock(kPeriod);
  for (int turn = 0; turn < 10; ++turn) clock.EndOf(turn * kPeriod);
  int lost = 0;
  for (int turn = 0; turn < 20; ++turn) {
    const double end = 1.006 + turn * kPeriod;
    const std::optional<double> told = clock.EndOf(end);
    if (!told) ++lost;
    if (told) {
      EXPECT_NEAR(*told, end, 1e-9);
    }
  }
  EXPECT_LE(lost, 6);
}

/// What has waited has a time only where none is missing; many that wait make no beat.
TEST(SweepClock, TellsNoTimeOfWhatHasWaitedAfterALoss) {
  constexpr double kTurn = 1.0 / 75.0;
  SweepClock clock(kTurn);
  for (int i = 0; i < 10; ++i) clock.EndOf(i * kTurn);
  EXPECT_NEAR(clock.EndOf(10.1 * kTurn, true).value_or(0.0), 10.0 * kTurn, 0.2 * kTurn) << "counted";
  for (int i = 0; i < 50; ++i)
    EXPECT_FALSE(clock.EndOf((20 + i) * kTurn, true)) << "9 were lost, or these are old";
  EXPECT_FALSE(clock.EndOf(80 * kTurn));
  clock.EndOf(81 * kTurn);
  clock.EndOf(82 * kTurn);
  EXPECT_TRUE(clock.EndOf(83 * kTurn)) << "what comes while somebody listens tells how many were lost";
}

}  // namespace
}  // namespace ariadne::drivers::lms200
