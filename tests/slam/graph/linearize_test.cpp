#include "slam/graph/linearize.h"

#include <gtest/gtest.h>

#include "slam/base/random.h"

namespace ariadne::slam {
namespace {

template <typename Pose>
typename Pose::Tangent RandomTangent(RandomStream& stream, double scale) {
  typename Pose::Tangent tau;
  for (double& value : tau.reshaped()) value = DrawUniform(stream, -scale, scale);
  return tau;
}

template <typename Pose>
struct Sample {
  Pose measured, from, to;
  RotationError rotation_error;

  typename Pose::Tangent Error(const typename Pose::Tangent& tau_from,
                               const typename Pose::Tangent& tau_to) const {
    return PoseError(measured, Retract(from, tau_from).Inverse() * Retract(to, tau_to), rotation_error);
  }
};

/// Differences between poses from small to all around.
template <typename Pose>
std::vector<Sample<Pose>> Samples() {
  RandomStream stream = NamedStream(11, "linearize");
  std::vector<Sample<Pose>> samples;
  for (const double scale : {1e-3, 0.3, 2.5}) {
    for (int k = 0; k < 20; ++k) {
      Sample<Pose> sample{Pose::Exp(RandomTangent<Pose>(stream, 2.0)),
                          Pose::Exp(RandomTangent<Pose>(stream, 2.0)), Pose(),
                          k % 2 == 0 ? RotationError::kChord : RotationError::kAngle};
      sample.to = sample.from * sample.measured * Pose::Exp(RandomTangent<Pose>(stream, scale));
      samples.push_back(sample);
    }
  }
  return samples;
}

template <typename Pose>
class LinearizeTest : public testing::Test {};
using Poses = testing::Types<Pose2, Pose3>;
TYPED_TEST_SUITE(LinearizeTest, Poses);

TYPED_TEST(LinearizeTest, AgreesWithDifferences) {
  using Pose = TypeParam;
  using Tangent = typename Pose::Tangent;
  constexpr double h = 1e-5;
  for (const Sample<Pose>& sample : Samples<Pose>()) {
    const LinearError<Pose> linear =
        Linearize(RotatedPose<Pose>(sample.measured), RotatedPose<Pose>(sample.from),
                  RotatedPose<Pose>(sample.to), sample.rotation_error);
    const Tangent zero = Tangent::Zero();
    ASSERT_LT((linear.e - sample.Error(zero, zero)).norm(), 1e-12);
    for (int k = 0; k < Pose::kDof; ++k) {
      const Tangent step = h * Tangent::Unit(k);
      const Tangent by_from = (sample.Error(step, zero) - sample.Error(-step, zero)) / (2.0 * h);
      const Tangent by_to = (sample.Error(zero, step) - sample.Error(zero, -step)) / (2.0 * h);
      if (by_from.norm() > 1e3 || by_to.norm() > 1e3) continue;  // the error jumps at half a turn
      EXPECT_LT((linear.J_from.col(k) - by_from).norm(), 1e-8);
      EXPECT_LT((linear.J_to.col(k) - by_to).norm(), 1e-8);
    }
  }
}

TYPED_TEST(LinearizeTest, CurvatureAgreesWithDifferencesOfTheGradient) {
  using Pose = TypeParam;
  using Tangent = typename Pose::Tangent;
  using Square = typename Pose::Square;
  constexpr double h = 1e-4;
  RandomStream stream = NamedStream(12, "curvature");
  for (const Sample<Pose>& sample : Samples<Pose>()) {
    const RotatedPose<Pose> measured(sample.measured);
    const LinearError<Pose> linear = Linearize(measured, RotatedPose<Pose>(sample.from),
                                               RotatedPose<Pose>(sample.to), sample.rotation_error);
    if (linear.e.template tail<1>().cwiseAbs()[0] > 1.8) continue;  // near the jump at half a turn
    const Tangent y = RandomTangent<Pose>(stream, 1.0);
    const Curvature<Pose> curvature = CurvatureOf(y, linear, measured, sample.rotation_error);
    const auto second = [&](const Tangent& a_from, const Tangent& a_to, const Tangent& b_from,
                            const Tangent& b_to) {
      const auto f = [&](double s, double t) {
        return y.dot(sample.Error(s * a_from + t * b_from, s * a_to + t * b_to));
      };
      return (f(h, h) - f(h, -h) - f(-h, h) + f(-h, -h)) / (4.0 * h * h);
    };
    Square from_from, from_to, to_to;
    const Tangent zero = Tangent::Zero();
    for (int i = 0; i < Pose::kDof; ++i) {
      for (int j = 0; j < Pose::kDof; ++j) {
        from_from(i, j) = second(Tangent::Unit(i), zero, Tangent::Unit(j), zero);
        from_to(i, j) = second(Tangent::Unit(i), zero, zero, Tangent::Unit(j));
        to_to(i, j) = second(zero, Tangent::Unit(i), zero, Tangent::Unit(j));
      }
    }
    EXPECT_LT((curvature.from_from - from_from).norm(), 1e-5);
    EXPECT_LT((curvature.from_to - from_to).norm(), 1e-5);
    EXPECT_LT((curvature.to_to - to_to).norm(), 1e-5);
  }
}

}  // namespace
}  // namespace ariadne::slam
