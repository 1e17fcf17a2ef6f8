#include "drivers/simulated/beam_cone.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace ariadne::drivers {
namespace {

/// White paper, head-on.
RayReturn White(double distance, double weight) { return {distance, weight, 1.0}; }

std::optional<Echo> Choose(std::vector<RayReturn> returns, const RangeFinderOptions& options = {}) {
  return ChooseEcho(returns, options);
}

TEST(BeamCone, HasACentreAndARimThatWeighOne) {
  RangeFinderOptions options;
  for (const int rim : {2, 4, 7}) {
    options.rim_rays = rim;
    const std::vector<double> weights = BeamCone(options).weights();
    EXPECT_EQ(weights.size(), 1u + static_cast<std::size_t>(rim));
    EXPECT_NEAR(std::accumulate(weights.begin(), weights.end(), 0.0), 1.0, 1e-15);
  }
  options.mixed_pixels = false;
  EXPECT_EQ(BeamCone(options).weights(), std::vector<double>{1.0});
}

TEST(BeamCone, RaysLieWithinTheDivergence) {
  const RangeFinderOptions options;
  const Ray beam{{1.0, 2.0, 3.0}, Eigen::Vector3d(1.0, -2.0, 0.5).normalized(), 4.5};
  std::vector<Ray> rays;
  BeamCone(options).AppendRays(beam, 0.7, rays);
  ASSERT_EQ(rays.size(), 5u);
  EXPECT_EQ(rays[0].direction_map, beam.direction_map);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 1; i < rays.size(); ++i) {
    const double angle = std::acos(rays[i].direction_map.dot(beam.direction_map));
    EXPECT_NEAR(angle, 0.5 * options.divergence * std::sqrt(2.0 / 3.0), 1e-7);
    EXPECT_NEAR(rays[i].direction_map.norm(), 1.0, 1e-15);
    EXPECT_EQ(rays[i].origin_map, beam.origin_map);
    EXPECT_EQ(rays[i].time, beam.time);
    sum += rays[i].direction_map;
  }
  EXPECT_LT(sum.normalized().cross(beam.direction_map).norm(), 1e-12) << "evenly around the centre";
}

TEST(ChooseEcho, GivesTheRangeOfASurfaceExactly) {
  const auto echo = Choose({White(3.1, 0.25), White(3.1, 0.375), White(3.1, 0.375)});
  ASSERT_TRUE(echo.has_value());
  EXPECT_EQ(echo->distance, 3.1);
  EXPECT_NEAR(echo->light, 1.0 / (3.1 * 3.1), 1e-15);
}

TEST(ChooseEcho, MixesWhatLiesWithinAPulse) {
  RangeFinderOptions options;
  options.pulse_length = 0.5;
  const auto echo = Choose({White(2.4, 0.5), White(2.0, 0.5)}, options);
  const double near = 0.5 / 4.0, far = 0.5 / 5.76;
  ASSERT_TRUE(echo.has_value());
  EXPECT_NEAR(echo->distance, (2.0 * near + 2.4 * far) / (near + far), 1e-12) << "weighed by light";
}

TEST(ChooseEcho, TakesTheFirstOrTheStrongestOfSeparateEchoes) {
  RangeFinderOptions options;
  const std::vector<RayReturn> returns{{2.0, 0.25, 0.1}, {4.0, 0.75, 0.9}};
  EXPECT_EQ(Choose(returns, options)->distance, 2.0);
  options.echo = EchoChoice::kStrongest;
  EXPECT_EQ(Choose(returns, options)->distance, 4.0);
}

TEST(ChooseEcho, PassesOverAFirstEchoThatIsTooWeak) {
  const std::vector<RayReturn> returns{{8.0, 0.1, 0.1}, {10.0, 0.9, 0.9}};
  EXPECT_EQ(Choose(returns)->distance, 10.0);
}

TEST(ChooseEcho, SeesASurfaceAsFarAsTheRootOfItsReflectance) {
  for (const double reflectance : {0.025, 0.1, 0.4, 0.9}) {
    const double limit = 10.0 * std::sqrt(reflectance / 0.1);
    EXPECT_TRUE(Choose({{0.999 * limit, 1.0, reflectance}}).has_value()) << reflectance;
    EXPECT_FALSE(Choose({{1.001 * limit, 1.0, reflectance}}).has_value()) << reflectance;
  }
}

TEST(ChooseEcho, SeesAnythingWithoutTheLimit) {
  RangeFinderOptions options;
  options.limit_by_reflectance = false;
  EXPECT_EQ(Choose({{60.0, 1.0, 0.0}}, options)->distance, 60.0);
  EXPECT_FALSE(Choose({}, options).has_value()) << "but nothing where there is nothing";
}

}  // namespace
}  // namespace ariadne::drivers
