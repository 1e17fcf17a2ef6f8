#include "experiments/studies/register_log.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/slam/geometry/pose_samples.h"
#include "tests/support/office_scans.h"

namespace ariadne::experiments {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::SizeIs;

/// The log of three scans of the office.
class RegisterLogTest : public testing::Test {
 protected:
  RegisterLogTest() {
    for (std::size_t i = 0; i < 3; ++i) {
      slam::Pose3 T_odom_laser = slam::LaserAt(drivers::OfficeTour()[i]);
      T_odom_laser.translation.x() += 0.05 * static_cast<double>(i);
      results_.push_back(
          mapper_.AddScan({"scan" + std::to_string(i),
                           slam::ScanOffice(slam::LaserAt(drivers::OfficeTour()[i]), i), T_odom_laser}));
      log_.Add(mapper_, results_.back(), 1000 + i, i != 2);
    }
  }
  slam::Mapper mapper_{slam::MapperOptions()};
  std::vector<slam::MatchResult> results_;
  RegisterLog log_;
};

TEST_F(RegisterLogTest, HasALinePerScanAlignmentAndIteration) {
  std::size_t steps = 0, iterations = 0;
  for (const slam::MatchResult& result : results_) {
    steps += result.steps.size();
    for (const slam::MatchStep& step : result.steps) iterations += step.align.iterations.size();
  }
  ASSERT_GT(steps, 2U);
  EXPECT_THAT(log_.scans.rows, SizeIs(3));
  EXPECT_THAT(log_.steps.rows, SizeIs(steps));
  EXPECT_THAT(log_.covariances.rows, SizeIs(steps));
  EXPECT_THAT(log_.iterations.rows, SizeIs(iterations));
}

TEST_F(RegisterLogTest, HasAColumnForEachCell) {
  for (const Table* table : {&log_.scans, &log_.steps, &log_.iterations, &log_.covariances}) {
    EXPECT_THAT(table->rows, Each(SizeIs(table->columns.size())));
  }
  EXPECT_THAT(log_.covariances.columns, SizeIs(2 + 21)) << "the upper triangle of 6 x 6";
}

TEST_F(RegisterLogTest, TellsHowFarAScanHasMovedFromItsGuess) {
  const double moved =
      slam::TranslationDistance(results_[1].T_map_laser_guess, mapper_.scans()[1].T_map_laser);
  EXPECT_NEAR(moved, 0.05, 0.02);
  EXPECT_EQ(log_.scans.columns[8], "moved_m");
  EXPECT_NEAR(std::stod(log_.scans.rows[1][8]), moved, 0.01);
  EXPECT_EQ(log_.scans.rows[0][8], "0") << "the master";
}

TEST_F(RegisterLogTest, HoldsThePosesOfAllScans) {
  ASSERT_THAT(log_.T_map_laser, SizeIs(3));
  EXPECT_THAT(log_.T_map_laser[2], slam::NearPose(mapper_.scans()[2].T_map_laser, 0.0));
  EXPECT_THAT(log_.points, ElementsAre(1000, 1001, 1002));
  EXPECT_THAT(log_.registered, ElementsAre(true, true, true));
  EXPECT_FALSE(log_.has_reflectance) << "the last scan has none";
}

TEST_F(RegisterLogTest, ReadsBackFromACheckpointToTheLastBit) {
  const std::string text = ToJson(log_).dump(2);
  const RegisterLog read = RegisterLogFromJson(Json::parse(text));
  EXPECT_EQ(ToJson(read).dump(2), text);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(read.T_map_laser[i].translation, log_.T_map_laser[i].translation);
    EXPECT_EQ(read.T_map_laser[i].rotation.coeffs(), log_.T_map_laser[i].rotation.coeffs());
  }
  EXPECT_EQ(read.has_reflectance, log_.has_reflectance);
}

}  // namespace
}  // namespace ariadne::experiments
