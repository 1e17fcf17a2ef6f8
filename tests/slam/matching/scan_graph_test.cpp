#include "slam/matching/scan_graph.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/slam/geometry/matrix_matchers.h"
#include "tests/support/random_geometry.h"

namespace ariadne::slam {
namespace {

/// What the odometry of 3 m from one scan to the next is worth in the graph, in a frame of the map.
Pose3::Square OdometryInformationBy(const ScanGraphOptions& options, const Pose3& T_map_first = {}) {
  ScanMap map;
  const Pose3 T_first_second{ExpSo3({0.0, 0.0, 1.2}), {1.8, 2.4, 0.0}};
  for (const Pose3& T_map_laser : {T_map_first, T_map_first * T_first_second})
    map.scans.push_back({"scan", {}, KdTree({}), T_map_laser, true});
  AddMissingNodes(map, options);
  EXPECT_EQ(map.graph.graph.edges.size(), 1u);
  return map.graph.graph.edges.front().information;
}

Pose3::Square InformationOfSigmas(const Pose3::Tangent& sigma) {
  return sigma.cwiseAbs2().cwiseInverse().asDiagonal();
}

TEST(AddMissingNodes, TrustsOdometryAlikeInAllDirectionsUnlessTheFloorIsEven) {
  ScanGraphOptions options;
  options.odometry_position = 0.1;
  options.odometry_angle = 0.02;
  const double position = std::hypot(0.05, 0.3), angle = std::hypot(0.05, 0.06);
  Pose3::Tangent sigma;
  sigma << position, position, position, angle, angle, angle;
  EXPECT_THAT(OdometryInformationBy(options), NearMatrix(InformationOfSigmas(sigma), 1e-9));
  options.floor_height = 0.01;
  options.floor_tilt = 0.005;
  sigma << position, position, 0.01, 0.005, 0.005, angle;
  EXPECT_THAT(OdometryInformationBy(options), NearMatrix(InformationOfSigmas(sigma), 1e-9));
}

TEST(AddMissingNodes, NeverTrustsTheFloorLessThanTheOdometry) {
  ScanGraphOptions options;
  const Pose3::Square without = OdometryInformationBy(options);
  options.floor_height = 10.0;
  options.floor_tilt = 1.0;
  EXPECT_THAT(OdometryInformationBy(options), NearMatrix(without, 0.0));
}

TEST(AddMissingNodes, TakesTheCovarianceOfWhoKnowsIt) {
  RandomStream stream = NamedStream(2, "scan_graph_test");
  Pose3::Square factor = 3.0 * Pose3::Square::Identity();
  for (double& entry : factor.reshaped()) entry += DrawUniform(stream, -1.0, 1.0);
  const Pose3::Square covariance = 1e-4 * factor * factor.transpose();
  ScanMap map;
  for (int i = 0; i < 3; ++i)
    map.scans.push_back({"scan", {}, KdTree({}), Pose3{Eigen::Quaterniond::Identity(), {i, 0, 0}}, true});
  map.scans[1].guess_covariance = covariance;
  AddMissingNodes(map, {});
  const auto& edges = map.graph.graph.edges;
  EXPECT_THAT(Pose3::Square(edges[0].information * covariance),
              NearMatrix(Pose3::Square::Identity(), 1e-9));
  EXPECT_GT((edges[1].information * covariance - Pose3::Square::Identity()).norm(), 0.1) << "by odometry";
}

TEST(AddMissingNodes, DoesNotDependOnTheMapsFrame) {
  ScanGraphOptions options;
  options.floor_height = 0.01;
  options.floor_tilt = 0.005;
  RandomStream stream = NamedStream(1, "scan_graph_test");
  const Pose3::Square expected = OdometryInformationBy(options);
  for (int i = 0; i < 10; ++i)
    EXPECT_THAT(OdometryInformationBy(options, DrawMotion(stream, 50.0, 3.0)), NearMatrix(expected, 1e-6));
}

}  // namespace
}  // namespace ariadne::slam
