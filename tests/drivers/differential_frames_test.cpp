#include "drivers/differential_frames.h"

#include <gtest/gtest.h>

namespace ariadne::drivers {
namespace {

using slam::LaserSweep;

LaserSweep Wall(double range, double stamp = 0.0) {
  LaserSweep sweep;
  sweep.stamp = stamp;
  sweep.ranges.assign(100, static_cast<float>(range));
  return sweep;
}

LaserSweep With(LaserSweep sweep, std::size_t first, std::size_t last, float range) {
  for (std::size_t b = first; b <= last; ++b) sweep.ranges[b] = range;
  return sweep;
}

TEST(DifferenceOf, FindsRunsOfBeamsThatChanged) {
  const LaserSweep after = With(With(Wall(5.0, 0.3), 10, 14, 3.0F), 96, 99, 4.5F);
  const auto moved = DifferenceOf(Wall(5.0), after, {}, 1);
  ASSERT_EQ(moved.size(), 2u);
  EXPECT_EQ(moved[0].first_beam, 10u);
  EXPECT_EQ(moved[0].last_beam, 14u);
  EXPECT_NEAR(moved[0].difference, 2.0, 1e-6);
  EXPECT_EQ(moved[0].scanner, 1u);
  EXPECT_EQ(moved[0].from_stamp, 0.0);
  EXPECT_EQ(moved[0].to_stamp, 0.3);
  EXPECT_EQ(moved[1].first_beam, 96u);
  EXPECT_EQ(moved[1].last_beam, 99u);
}

TEST(DifferenceOf, PassesOverNoiseAndSingleBeams) {
  EXPECT_TRUE(DifferenceOf(Wall(5.0), Wall(5.03), {}).empty());
  EXPECT_TRUE(DifferenceOf(Wall(5.0), With(Wall(5.0), 10, 11, 3.0F), {}).empty());
}

TEST(DifferenceOf, SeesWhatAppearsBeforeNothing) {
  const LaserSweep nothing = Wall(LaserSweep::kNoReturn);
  EXPECT_EQ(DifferenceOf(nothing, With(nothing, 50, 53, 6.0F), {}).size(), 1u);
  EXPECT_EQ(DifferenceOf(With(nothing, 50, 53, 6.0F), nothing, {}).size(), 1u);
  EXPECT_TRUE(DifferenceOf(nothing, nothing, {}).empty());
}

TEST(DifferenceOf, PassesOverWhatIsFarAway) {
  EXPECT_TRUE(DifferenceOf(Wall(16.0), Wall(22.0), {}).empty());
  EXPECT_TRUE(DifferenceOf(Wall(14.99), Wall(15.01), {}).empty()) << "at max_range only the noise counts";
}

TEST(DifferenceOf, NeedsFramesOfOneScanner) {
  LaserSweep other = Wall(5.0);
  other.ranges.pop_back();
  EXPECT_THROW(DifferenceOf(Wall(5.0), other, {}), Error);
}

TEST(DetectMotion, ComparesEachFrameWithTheOneBefore) {
  const SafetySweep still{{}, {}, Wall(5.0)};
  const SafetySweep changed{{}, {}, With(Wall(5.0), 20, 30, 2.0F)};
  const std::vector<std::vector<SafetySweep>> frames{{still, still}, {still, changed}, {still, changed}};
  const auto moved = DetectMotion(frames, {});
  ASSERT_EQ(moved.size(), 1u) << "what stays where it went has stopped moving";
  EXPECT_EQ(moved[0].scanner, 1u);
  EXPECT_TRUE(DetectMotion({}, {}).empty());
}

TEST(DetectMotion, NeedsTheSameScannersInAllFrames) {
  const SafetySweep sweep{{}, {}, Wall(5.0)};
  const std::vector<std::vector<SafetySweep>> frames{{sweep, sweep}, {sweep}};
  EXPECT_THROW(DetectMotion(frames, {}), Error);
}

}  // namespace
}  // namespace ariadne::drivers
