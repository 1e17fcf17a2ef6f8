// The real hallway, on which two independent programs (3DTK and a plain loop) agree with each other.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ostream>
#include <string>

#include "slam/geometry/angles.h"
#include "slam/io/uos_axes.h"
#include "slam/registration/align.h"
#include "tests/slam/geometry/matrix_matchers.h"
#include "tests/support/hallway.h"
#include "tests/support/random_geometry.h"

namespace ariadne::slam {
namespace {

/// What the others find for one scan in the frame of the one before.
struct Reference {
  std::size_t data;
  double max_distance;
  Eigen::Vector3d position_cm, euler_deg;
  std::size_t pairs;
  double rms_cm;
};

void PrintTo(const Reference& reference, std::ostream* out) {
  *out << "scan " << reference.data << ", gate " << reference.max_distance << " m";
}

const Reference kReferences[] = {
    {1, 0.5, {-3.3444, -9.5743, 154.8203}, {0.78424, -0.80537, -0.01368}, 75875, 8.7213},
    {1, 0.25, {-3.6579, -8.9997, 156.8208}, {0.79241, -0.73791, -0.30448}, 73198, 5.886},
    {2, 0.5, {-1.4788, -6.9265, 175.3888}, {-1.00551, 0.42706, 0.91641}, 75829, 9.5768},
};

AlignResult AlignScan(const std::vector<PosedCloud>& scans, std::size_t data,
                      const Pose3& T_model_data_guess, const AlignOptions& options) {
  return Align(scans[data - 1].cloud_laser, scans[data].cloud_laser, T_model_data_guess, options);
}

Pose3 GuessOf(const std::vector<PosedCloud>& scans, std::size_t data) {
  return scans[data - 1].T_map_laser.Inverse() * scans[data].T_map_laser;
}

class HallwayPair : public HallwayTest, public testing::WithParamInterface<Reference> {};
INSTANTIATE_TEST_SUITE_P(References, HallwayPair, testing::ValuesIn(kReferences));

TEST_P(HallwayPair, IsAlignedAsByTwoOtherPrograms) {
  const Reference& reference = GetParam();
  AlignOptions options;
  options.max_distance = reference.max_distance;
  options.convergence_rms = 1e-7;  // 1e-5 cm
  const AlignResult result = AlignScan(Scans(), reference.data, GuessOf(Scans(), reference.data), options);
  EXPECT_TRUE(result.converged()) << result.message;
  const UosPose pose = ToUosPose(result.T_model_data);
  EXPECT_THAT(pose.position_cm, NearMatrix(reference.position_cm, 1e-3));
  EXPECT_THAT(pose.euler_deg, NearMatrix(reference.euler_deg, 1e-3));
  EXPECT_NEAR(100.0 * result.rms, reference.rms_cm, 2e-3);
  // One pair at the very gate is in or out by how the distance is rounded.
  EXPECT_NEAR(static_cast<double>(result.pairs), static_cast<double>(reference.pairs), 3.0);
}

class HallwayByMetric : public HallwayTest, public testing::WithParamInterface<Metric> {};
INSTANTIATE_TEST_SUITE_P(Metrics, HallwayByMetric,
                         testing::Values(Metric::kPointToPoint, Metric::kPointToPlane,
                                         Metric::kPlaneToPlane),
                         [](const auto& metric) { return std::string(ariadne::NameOf(metric.param)); });

TEST_P(HallwayByMetric, ConvergesToTheSamePoseFromAPerturbedStart) {
  AlignOptions options;
  options.metric = GetParam();
  options.convergence_rms = 1e-8;
  const AlignModel model = PrepareModel(Scans()[0].cloud_laser, options);
  const AlignData data = PrepareData(Scans()[1].cloud_laser, options);
  const Pose3 guess = GuessOf(Scans(), 1);
  const AlignResult expected = Align(model, data, guess, options);
  ASSERT_TRUE(expected.converged()) << expected.message;
  RandomStream stream = NamedStream(1, "align_hallway_test");
  const Pose3 error{ExpSo3(RadFromDeg(3.0) * DrawDirection(stream)), 0.2 * DrawDirection(stream)};
  const AlignResult result = Align(model, data, guess * error, options);
  EXPECT_TRUE(result.converged()) << result.message;
  // Point-to-point creeps to its end in many short steps, the last of which the rms does not show.
  const double tolerance = GetParam() == Metric::kPointToPoint ? 1e-4 : 1e-9;  // [m], [rad]
  EXPECT_LT(TranslationDistance(result.T_model_data, expected.T_model_data), tolerance);
  EXPECT_LT(RotationDistance(result.T_model_data, expected.T_model_data), tolerance);
}

}  // namespace
}  // namespace ariadne::slam
