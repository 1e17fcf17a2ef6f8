#include "experiments/render/colored_points.h"

#include <gmock/gmock.h>

#include <limits>

#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

/// Two scans, the second one 10 m ahead of the first.
std::vector<slam::PosedCloud> TwoScans() {
  slam::PosedCloud first{"first", {}, {}};
  first.cloud_laser.positions = {{1, 0, 0}, {1, 0, 2.5}};
  slam::PosedCloud second = first;
  second.name = "second";
  second.T_map_laser.translation = {10, 0, 0};
  return {first, second};
}

TEST(ColoredPoints, ByScan) {
  const ColoredPoints points = ColoredByScan(TwoScans());
  ASSERT_EQ(points.positions_map.size(), 4U);
  EXPECT_EQ(points.positions_map[2], Eigen::Vector3d(11, 0, 0));
  EXPECT_EQ(points.colors, (std::vector<Rgb>{CategoricalColor(0), CategoricalColor(0), CategoricalColor(1),
                                             CategoricalColor(1)}));
}

TEST(ColoredPoints, WithoutTheCeiling) {
  const ColoredPoints points = ColoredByScan(TwoScans(), {.max = 2.0});
  EXPECT_EQ(points.positions_map, (std::vector<Eigen::Vector3d>{{1, 0, 0}, {11, 0, 0}}));
  EXPECT_EQ(points.colors[1], CategoricalColor(1));
}

TEST(ColoredPoints, ByHeight) {
  const std::vector<Eigen::Vector3d> positions = PositionsInMap(TwoScans());
  const ValueRange range = HeightRange(positions);
  EXPECT_EQ(range.low, 0.0);
  EXPECT_EQ(range.high, 2.5);
  const ColoredPoints points = ColoredByHeight(positions, range, ColorMap::kSea);
  EXPECT_EQ(points.colors[0], ColorAt(ColorMap::kSea, 0.0));
  EXPECT_EQ(points.colors[3], ColorAt(ColorMap::kSea, 1.0));
}

TEST(ColoredPoints, ByValue) {
  const ColoredPoints points =
      ColoredByValue({{0, 0, 0}, {1, 0, 0}}, {0.5, 9.0}, ColorMap::kHeat, {0.0, 2.0});
  EXPECT_EQ(points.colors[0], ColorAt(ColorMap::kHeat, 0.25));
  EXPECT_EQ(points.colors[1], ColorAt(ColorMap::kHeat, 1.0));
  EXPECT_THAT(
      [] {
        ColoredByValue({{0, 0, 0}}, {}, ColorMap::kHeat, {});
      },
      ThrowsMessage<Error>(HasSubstr("1 points")));
}

TEST(ColoredPoints, ByReflectanceOfEveryScan) {
  auto scans = TwoScans();
  for (auto& scan : scans) scan.cloud_laser.reflectance = {10.0F, 30.0F};
  EXPECT_EQ(ColoredByReflectance(scans).colors[3], ColorAt(ColorMap::kGray, 1.0));
  scans[1].cloud_laser.reflectance.clear();
  EXPECT_THAT([&] { ColoredByReflectance(scans); }, ThrowsMessage<Error>(HasSubstr("second")));
}

TEST(ColoredPoints, Lightened) {
  EXPECT_EQ(Lightened({{{0, 0, 0}}, {kBlack}}, 0.2).colors[0], (Rgb{51, 51, 51}));
}

TEST(RequireDrawable, NamesWhatIsWrong) {
  EXPECT_THAT([] { RequireDrawable({{{0, 0, 0}}, {}}); }, ThrowsMessage<Error>(HasSubstr("0 colours")));
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THAT(
      [&] {
        RequireDrawable({{{0, 0, 0}, {0, infinity, 0}}, {kBlack, kBlack}});
      },
      ThrowsMessage<Error>(HasSubstr("point 1 of 2")));
  RequireDrawable({});
}

TEST(HeightBand, KeepsNanToBeRefusedLater) {
  const HeightBand band{.min = 0.0, .max = 1.0};
  EXPECT_FALSE(band.Excludes({0, 0, std::numeric_limits<double>::quiet_NaN()}));
  EXPECT_TRUE(band.Excludes({0, 0, 1.1}));
  EXPECT_FALSE(band.Excludes({0, 0, 1.0}));
}

}  // namespace
}  // namespace ariadne::experiments
