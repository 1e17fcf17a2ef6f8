#include "slam/registration/pair_filter.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "slam/registration/align.h"
#include "tests/support/random_geometry.h"

namespace ariadne::slam {
namespace {

SurfacePoint SurfaceWith(const Eigen::Vector3d& normal, bool boundary = false) {
  return {normal, boundary, 0.1};
}

TEST(AreOpposite, ComparesTheSidesFromWhichPointsWereSeen) {
  const SurfacePoint left = SurfaceWith(-Eigen::Vector3d::UnitX());
  const SurfacePoint right = SurfaceWith(Eigen::Vector3d::UnitX());
  const SurfacePoint none = SurfaceWith(Eigen::Vector3d::Zero());
  const Eigen::Matrix3d same = Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d about = ExpSo3({0.0, 0.0, 3.0}).toRotationMatrix();
  EXPECT_TRUE(AreOpposite(left, right, same));
  EXPECT_FALSE(AreOpposite(left, left, same));
  EXPECT_TRUE(AreOpposite(left, left, about)) << "the scanners look at it from both sides";
  EXPECT_FALSE(AreOpposite(left, right, about));
  EXPECT_FALSE(AreOpposite(none, right, same));
  EXPECT_FALSE(AreOpposite(left, none, same));
}

TEST(AreOpposite, DoesNotDependOnTheFrames) {
  RandomStream stream = NamedStream(1, "pair_filter_test");
  for (int i = 0; i < 50; ++i) {
    const Eigen::Vector3d model = DrawDirection(stream), data = DrawDirection(stream);
    const Eigen::Matrix3d R = ExpSo3(DrawInBall(stream, 3.0)).toRotationMatrix();
    const Eigen::Matrix3d A = ExpSo3(DrawInBall(stream, 3.0)).toRotationMatrix();
    const Eigen::Matrix3d B = ExpSo3(DrawInBall(stream, 3.0)).toRotationMatrix();
    EXPECT_EQ(AreOpposite(SurfaceWith(A * model), SurfaceWith(B * data), A * R * B.transpose()),
              AreOpposite(SurfaceWith(model), SurfaceWith(data), R));
  }
}

TEST(PairFilter, KeepsWhatTheOptionsAskFor) {
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX();
  const std::vector<SurfacePoint> model{SurfaceWith(x), SurfaceWith(x, true),
                                        SurfaceWith(Eigen::Vector3d::Zero())};
  const std::vector<SurfacePoint> data{SurfaceWith(x), SurfaceWith(-x),
                                       SurfaceWith(Eigen::Vector3d::Zero())};
  /// A row per point of the data, a column per point of the model.
  const auto kept = [&](const AlignOptions& options) {
    const PairFilter filter(model, data, {}, options);
    std::string rows;
    for (std::size_t d = 0; d < data.size(); ++d) {
      for (std::uint32_t m = 0; m < model.size(); ++m) rows += filter.Keeps(d, m) ? '+' : '-';
      rows += ' ';
    }
    return rows;
  };
  AlignOptions options;
  EXPECT_EQ(kept(options), "+++ +++ +++ ");
  options.one_sided = true;
  EXPECT_EQ(kept(options), "+++ --+ +++ ");
  options.skip_boundary = true;
  EXPECT_EQ(kept(options), "+-+ --+ +-+ ");
  options.metric = Metric::kPointToPlane;
  EXPECT_EQ(kept(options), "+-- --- +-- ");
  options = {};
  options.metric = Metric::kPlaneToPlane;
  EXPECT_EQ(kept(options), "++- ++- --- ");
}

/// Adds a rectangle of the map, its points off their lattice: corner + s u + t v.
void AddRectangle(RandomStream& stream, const Eigen::Vector3d& corner, const Eigen::Vector3d& u,
                  const Eigen::Vector3d& v, std::vector<Eigen::Vector3d>& points) {
  const auto count = static_cast<std::size_t>(60.0 * u.norm() * v.norm());
  for (std::size_t i = 0; i < count; ++i) {
    const double along_u = DrawUniform(stream, 0.0, 1.0), along_v = DrawUniform(stream, 0.0, 1.0);
    points.emplace_back(corner + along_u * u + along_v * v);
  }
}

/// Two rooms that share a wall of 12 cm, as a scanner in the room before (x < 0) or behind the wall sees
/// them: the wall's own side, and, through a wide door, floor, outer walls and a little of an end wall.
PointCloud ScanOfRoom(const Pose3& T_map_laser, bool before, std::uint64_t seed) {
  RandomStream stream = NamedStream(seed, "pair_filter_test/room");
  std::vector<Eigen::Vector3d> points;
  AddRectangle(stream, {before ? 0.0 : 0.12, -2.0, 0.0}, {0.0, 4.0, 0.0}, {0.0, 0.0, 2.5}, points);
  AddRectangle(stream, {-3.0, -3.0, 0.0}, {6.0, 0.0, 0.0}, {0.0, 6.0, 0.0}, points);
  for (const double y : {-3.0, 3.0})
    AddRectangle(stream, {-3.0, y, 0.0}, {6.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, points);
  AddRectangle(stream, {3.0, 2.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 2.5}, points);
  PointCloud cloud;
  for (const Eigen::Vector3d& p : points) cloud.positions.push_back(T_map_laser.Inverse() * p);
  return cloud;
}

class ThinWall : public testing::TestWithParam<Metric> {};
INSTANTIATE_TEST_SUITE_P(Metrics, ThinWall,
                         testing::Values(Metric::kPointToPoint, Metric::kPointToPlane,
                                         Metric::kPlaneToPlane),
                         [](const auto& metric) { return std::string(ariadne::NameOf(metric.param)); });

TEST_P(ThinWall, KeepsItsThicknessIfItsSidesAreNotPaired) {
  const Pose3 T_map_model{ExpSo3({0.0, 0.0, 0.4}), {-2.0, 0.5, 1.0}};
  const Pose3 T_map_data{ExpSo3({0.0, 0.0, 2.9}), {2.0, -0.5, 1.0}};
  const Pose3 truth = T_map_model.Inverse() * T_map_data;
  AlignOptions options;
  options.metric = GetParam();
  options.max_distance = 0.2;
  std::vector<double> pressed, kept;
  for (std::uint64_t seed = 2; seed < 12; seed += 2) {
    const PointCloud model = ScanOfRoom(T_map_model, true, seed);
    const PointCloud data = ScanOfRoom(T_map_data, false, seed + 1);
    const auto error = [&](bool one_sided) {
      options.one_sided = one_sided;
      return TranslationDistance(Align(model, data, truth, options).T_model_data, truth);
    };
    pressed.push_back(error(false));
    kept.push_back(error(true));
  }
  std::ranges::sort(kept);
  EXPECT_GT(*std::ranges::min_element(pressed), 0.05) << "the wall is pressed thin";
  EXPECT_LT(kept[2], 0.015) << "the median; random points hold little along the wall";
  EXPECT_LT(kept.back(), 0.05);
}

}  // namespace
}  // namespace ariadne::slam
