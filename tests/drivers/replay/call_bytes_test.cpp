#include "drivers/replay/call_bytes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "slam/base/error.h"
#include "tests/drivers/replay/calls.h"

namespace ariadne::drivers {
namespace {

bool SameMemory(const std::vector<float>& a, const std::vector<float>& b) {
  if (a.size() != b.size()) return false;
  return a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

/// The memory of the numbers of a sweep, which is the oracle here: equal memory, equal bits.
void ExpectSameSweep(const slam::LaserSweep& a, const slam::LaserSweep& b) {
  EXPECT_EQ(std::memcmp(&a.stamp, &b.stamp, 3 * sizeof(double)), 0);
  EXPECT_TRUE(SameMemory(a.ranges, b.ranges));
  EXPECT_TRUE(SameMemory(a.reflectance, b.reflectance));
}

template <typename Call>
Call Again(const Call& call) {
  return std::get<Call>(DecodeCall(EncodeCall(call)));
}

TEST(CallBytes, KeepEachBitOfAScan) {
  RandomStream stream = NamedStream(1, "scan");
  for (int trial = 0; trial < 50; ++trial) {
    const auto call = std::get<ScanCall>(AnyCall(stream, CallKind::kScan));
    const ScanCall again = Again(call);
    ASSERT_EQ(again.scan.sweeps.size(), call.scan.sweeps.size());
    for (std::size_t s = 0; s < call.scan.sweeps.size(); ++s) {
      ExpectSameSweep(again.scan.sweeps[s], call.scan.sweeps[s]);
    }
    const slam::Odometry &a = again.scan.odometry, &b = call.scan.odometry;
    EXPECT_EQ(std::memcmp(&a.T_odom_base.angle, &b.T_odom_base.angle, sizeof(double)), 0);
    EXPECT_EQ(std::memcmp(&a.T_odom_base.translation, &b.T_odom_base.translation, 2 * sizeof(double)), 0);
    EXPECT_EQ(std::memcmp(&a.covariance, &b.covariance, 9 * sizeof(double)), 0);
    EXPECT_EQ(std::memcmp(&again.scan.scanner.angle_step, &call.scan.scanner.angle_step, 8), 0);
    EXPECT_EQ(again.scan.scanner.turns_per_sweep, call.scan.scanner.turns_per_sweep);
  }
}

TEST(CallBytes, KeepEachBitOfSafetySweeps) {
  RandomStream stream = NamedStream(2, "safety");
  for (int trial = 0; trial < 50; ++trial) {
    const auto call = std::get<SafetySweepsCall>(AnyCall(stream, CallKind::kSafetySweeps));
    const SafetySweepsCall again = Again(call);
    ASSERT_EQ(again.sweeps.size(), call.sweeps.size());
    for (std::size_t s = 0; s < call.sweeps.size(); ++s) {
      ExpectSameSweep(again.sweeps[s].sweep, call.sweeps[s].sweep);
      const slam::Pose3 &a = again.sweeps[s].T_base_laser, &b = call.sweeps[s].T_base_laser;
      EXPECT_EQ(std::memcmp(a.rotation.coeffs().data(), b.rotation.coeffs().data(), 4 * sizeof(double)), 0);
      EXPECT_EQ(std::memcmp(a.translation.data(), b.translation.data(), 3 * sizeof(double)), 0);
    }
  }
}

TEST(CallBytes, KeepWhatTheRobotSays) {
  const StateCall state{{3.25, {{0.5, {1.0, -2.0}}, Eigen::Matrix3d::Random()}, {0.4, -0.1}, true}};
  const StateCall again = Again(state);
  EXPECT_EQ(again.state.stamp, 3.25);
  EXPECT_EQ(again.state.odometry.T_odom_base.angle, 0.5);
  EXPECT_EQ(again.state.odometry.T_odom_base.translation, Eigen::Vector2d(1.0, -2.0));
  EXPECT_EQ(again.state.odometry.covariance, state.state.odometry.covariance);
  EXPECT_EQ(again.state.velocity.forward, 0.4);
  EXPECT_EQ(again.state.velocity.turning, -0.1);
  EXPECT_TRUE(again.state.blocked);
  EXPECT_EQ(Again(NowCall{1e-300}).time, 1e-300);
  EXPECT_EQ(Again(WaitCall{-1.0}).until, -1.0);
  EXPECT_EQ(Again(DriveCall{{0.1, 0.2}}).velocity.turning, 0.2);
  EXPECT_EQ(Again(Note{std::string("a\0b", 3)}).text, std::string("a\0b", 3));
}

TEST(CallBytes, AreRefusedWhereTheyBreakOffOrGoOn) {
  RandomStream stream = NamedStream(3, "cut");
  for (int kind = 0; kind < static_cast<int>(CallKind::kNote); ++kind) {
    const std::string bytes = EncodeCall(AnyCall(stream, static_cast<CallKind>(kind)));
    for (std::size_t size = 0; size < bytes.size(); ++size) {
      EXPECT_THROW(DecodeCall(bytes.substr(0, size)), Error) << "kind " << kind << ", " << size << " bytes";
    }
    EXPECT_THROW(DecodeCall(bytes + '\0'), Error) << "kind " << kind;
  }
}

TEST(CallBytes, ThatAreFlippedAreRefusedOrAnotherCall) {
  RandomStream stream = NamedStream(4, "flips");
  for (int trial = 0; trial < 300; ++trial) {
    std::string bytes = EncodeCall(trial % 2 == 0 ? AnyCall(stream) : SweepCall{LikelySweep(stream, 90)});
    bytes[stream() % bytes.size()] ^= static_cast<char>(1 << (stream() % 8));
    try {
      const std::string again = EncodeCall(DecodeCall(bytes));
      EXPECT_EQ(EncodeCall(DecodeCall(again)), again);
    } catch (const Error&) {
    }
  }
}

TEST(CallBytes, AreFewForWhatScannersMeasure) {
  RandomStream stream = NamedStream(5, "size");
  slam::LaserSweep sweep = LikelySweep(stream, 361);
  EXPECT_LT(EncodeCall(SweepCall{sweep}).size(), 3U * 361U) << "of 8 bytes in memory";
  sweep.ranges[7] += 1e-4F;  // no millimetres any more
  EXPECT_GT(EncodeCall(SweepCall{sweep}).size(), 4U * 361U);
}

TEST(AskTheSame, LooksAtEachBitOfArguments) {
  EXPECT_TRUE(AskTheSame(DriveCall{{0.1, 0.2}}, DriveCall{{0.1, 0.2}}));
  EXPECT_FALSE(AskTheSame(DriveCall{{0.1, 0.2}}, DriveCall{{0.1, std::nextafter(0.2, 1.0)}}));
  EXPECT_FALSE(AskTheSame(DriveCall{{0.0, 0.2}}, DriveCall{{-0.0, 0.2}}));
  EXPECT_FALSE(AskTheSame(WaitCall{1.0}, WaitCall{std::nextafter(1.0, 2.0)}));
  EXPECT_TRUE(AskTheSame(NowCall{1.0}, NowCall{2.0})) << "answers do not count";
  EXPECT_FALSE(AskTheSame(NowCall{}, StateCall{}));
}

}  // namespace
}  // namespace ariadne::drivers
