#include "experiments/run/office_scans.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drivers/simulated/box_world.h"

namespace ariadne::experiments {
namespace {

using slam::Pose3;

OfficeScanOptions Coarse() {
  OfficeScanOptions options;
  options.beams = 31;
  options.slices = 12;
  return options;
}

TEST(TrueLaserPoses, StandAMetreAboveTheStopsAlmostLevel) {
  const std::vector<Pose3> poses = TrueLaserPoses(OfficeScanOptions());
  const std::vector<slam::Pose2> stops = drivers::OfficeTour();
  ASSERT_EQ(poses.size(), stops.size());
  double largest_tilt = 0.0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    EXPECT_LT((poses[i].translation.head<2>() - stops[i].translation).norm(), 0.02) << "the floor tilts it";
    EXPECT_NEAR(poses[i].translation.z(), 1.0, 1e-3);
    const double tilt = std::acos((poses[i].rotation * Eigen::Vector3d::UnitZ()).z());
    EXPECT_LT(tilt, 5.0 * 0.005) << i;
    largest_tilt = std::max(largest_tilt, tilt);
  }
  EXPECT_GT(largest_tilt, 0.001);
}

TEST(OdometryPoses, AreTheTruthWhereNothingErrs) {
  OfficeScanOptions options;
  options.odometry_sigma = options.heading_sigma = 0.0;
  const std::vector<Pose3> truth = TrueLaserPoses(options), odometry = OdometryPoses(options);
  ASSERT_EQ(odometry.size(), truth.size());
  for (std::size_t i = 0; i < truth.size(); ++i) {
    EXPECT_LT(slam::TranslationDistance(odometry[i], truth[i]), 1e-12);
    EXPECT_LT(slam::RotationDistance(odometry[i], truth[i]), 1e-7);
  }
}

TEST(OdometryPoses, StartAtTheTruthAndDriftInThePlane) {
  const OfficeScanOptions options;
  const std::vector<Pose3> truth = TrueLaserPoses(options), odometry = OdometryPoses(options);
  EXPECT_EQ(slam::TranslationDistance(odometry[0], truth[0]), 0.0);
  for (std::size_t i = 1; i < truth.size(); ++i) {
    const Pose3 motion = truth[i - 1].Inverse() * truth[i];
    const Pose3 measured = odometry[i - 1].Inverse() * odometry[i];
    const Pose3::Tangent error = (motion.Inverse() * measured).Log();
    EXPECT_GT(error.head<2>().norm(), 0.0) << i;
    EXPECT_LT(error.head<2>().cwiseAbs().maxCoeff(), 5.0 * 0.05) << i;
    EXPECT_LT(std::abs(error(5)), 5.0 * 0.03) << i;
    EXPECT_NEAR(error(2), 0.0, 1e-9) << "no error of the height";
    EXPECT_NEAR(error.segment<2>(3).norm(), 0.0, 1e-9) << "nor of roll and pitch";
  }
}

TEST(OfficeScans, AreAsManyAsAskedFor) {
  OfficeScanOptions options;
  options.scans = 3;
  EXPECT_EQ(TrueLaserPoses(options).size(), 3U);
  EXPECT_EQ(OdometryPoses(options).size(), 3U);
}

TEST(ScanOffice, IsOrganizedAndOnTheWallsWithoutNoise) {
  OfficeScanOptions options = Coarse();
  options.range_sigma = 0.0;
  const slam::PointCloud cloud = ScanOffice(options, 2);
  EXPECT_EQ(cloud.size(), 31U * 12U);
  EXPECT_EQ(cloud.slice_begin.size(), 12U);
  const drivers::BoxWorld office = drivers::MakeOffice();
  const Pose3 T_map_laser = TrueLaserPoses(options)[2];
  for (const Eigen::Vector3d& p : cloud.positions) {
    const auto hit =
        drivers::CastRay(office, T_map_laser.translation, T_map_laser.rotation * p.normalized());
    ASSERT_TRUE(hit.has_value());
    EXPECT_GT(*hit, p.norm() - 1e-5) << "nothing is before the point";
  }
}

/// How much noise changes the range of each point.
std::vector<double> RangeErrors(std::size_t stop) {
  OfficeScanOptions exact = Coarse();
  exact.range_sigma = 0.0;
  const slam::PointCloud noisy = ScanOffice(Coarse(), stop), true_points = ScanOffice(exact, stop);
  std::vector<double> errors;
  for (std::size_t i = 0; i < noisy.size(); ++i) {
    errors.push_back(noisy.positions[i].norm() - true_points.positions[i].norm());
  }
  return errors;
}

TEST(ScanOffice, DisturbsDifferentStopsDifferently) {
  const std::vector<double> a = RangeErrors(1), b = RangeErrors(2);
  ASSERT_EQ(a.size(), b.size());
  double difference = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) difference = std::max(difference, std::abs(a[i] - b[i]));
  EXPECT_GT(difference, 0.005) << "two draws of sigma 5 mm; the same stream would differ by rounding";
}

TEST(ScanOffice, DrawsANoiseOfItsOwnForEachStopAndSeed) {
  OfficeScanOptions options = Coarse();
  const slam::PointCloud first = ScanOffice(options, 1);
  EXPECT_EQ(ScanOffice(options, 1).positions, first.positions);
  options.scans = 2;
  EXPECT_EQ(ScanOffice(options, 1).positions, first.positions) << "however many scans there are";
  options.odometry_sigma = 1.0;
  EXPECT_EQ(ScanOffice(options, 1).positions, first.positions) << "however bad odometry is";
  options.seed = 2;
  EXPECT_NE(ScanOffice(options, 1).positions, first.positions);
}

}  // namespace
}  // namespace ariadne::experiments
