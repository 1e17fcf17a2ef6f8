#include "slam/scan/slices.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>
#include <utility>

#include "slam/base/random.h"
#include "tests/slam/scan/simulated_scan.h"

namespace ariadne::slam {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<Eigen::Vector3d> Reversed(std::vector<Eigen::Vector3d> points) {
  std::ranges::reverse(points);
  return points;
}

/// The slices of the points in reversed order: the last point of each is its first.
std::vector<std::size_t> ReversedSlices(const PointCloud& cloud) {
  std::vector<std::size_t> begins{0};
  for (std::size_t s = cloud.slice_begin.size() - 1; s > 0; --s) {
    begins.push_back(cloud.size() - cloud.slice_begin[s]);
  }
  return begins;
}

/// Takes away the returns of a share of the beams, each on its own.
Scan WithLostReturns(Scan scan, double share) {
  RandomStream stream = NamedStream(1, "slices_test/lost");
  for (LaserSweep& sweep : scan.sweeps) {
    for (float& range : sweep.ranges) {
      if (DrawUniform(stream, 0.0, 1.0) < share) range = LaserSweep::kNoReturn;
    }
  }
  return scan;
}

/// Takes away the returns of a whole sector, as an open door or a window does.
Scan WithGap(Scan scan, double from_deg, double to_deg) {
  for (LaserSweep& sweep : scan.sweeps) {
    for (std::size_t beam = 0; beam < sweep.ranges.size(); ++beam) {
      const double angle = DegFromRad(static_cast<double>(beam) * scan.scanner.angle_step);
      if (angle > from_deg && angle < to_deg) sweep.ranges[beam] = LaserSweep::kNoReturn;
    }
  }
  return scan;
}

class InferSlicesOfScan : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Turns, InferSlicesOfScan, testing::Values(1, 2, 4));

TEST_P(InferSlicesOfScan, FindsTheSweepsOfACompleteScan) {
  const PointCloud cloud = ToPointCloud(ScanOfRoom(GetParam(), 64));
  EXPECT_EQ(InferSlices(cloud.positions), cloud.slice_begin);
}

TEST_P(InferSlicesOfScan, FindsThemWithLostReturns) {
  const PointCloud cloud = ToPointCloud(WithLostReturns(ScanOfRoom(GetParam(), 64), 0.4));
  EXPECT_EQ(InferSlices(cloud.positions), cloud.slice_begin);
}

TEST_P(InferSlicesOfScan, FindsThemWithAWholeSectorMissing) {
  for (const double step_deg : {120.0 / 128.0, 120.0 / 256.0, 120.0 / 500.0}) {
    for (const auto& [from, to] : {std::pair{2.0, 40.0}, {60.0, 120.0}, {10.0, 170.0}, {125.0, 170.0}}) {
      const PointCloud cloud = ToPointCloud(WithGap(ScanOfRoom(GetParam(), 20, step_deg), from, to));
      EXPECT_EQ(InferSlices(cloud.positions), cloud.slice_begin)
          << step_deg << ", gap " << from << "-" << to;
      EXPECT_EQ(InferSlices(Reversed(cloud.positions)), ReversedSlices(cloud)) << "reversed";
    }
  }
}

TEST_P(InferSlicesOfScan, FindsTheSweepsOfANarrowScanner) {
  const Scan scan = WithGap(WithGap(ScanOfRoom(GetParam(), 64), -1.0, 40.0), 140.0, 181.0);
  const PointCloud cloud = ToPointCloud(scan);
  EXPECT_EQ(InferSlices(cloud.positions), cloud.slice_begin);
}

TEST_P(InferSlicesOfScan, FindsReversedSweeps) {
  const PointCloud cloud = ToPointCloud(WithLostReturns(ScanOfRoom(GetParam(), 64), 0.1));
  EXPECT_EQ(InferSlices(Reversed(cloud.positions)), ReversedSlices(cloud));
}

TEST_P(InferSlicesOfScan, FindsNothingInShuffledPoints) {
  auto positions = ToPointCloud(ScanOfRoom(GetParam(), 64)).positions;
  RandomStream stream = NamedStream(1, "slices_test/shuffle");
  for (std::size_t i = positions.size() - 1; i > 0; --i) {
    std::swap(positions[i], positions[stream() % (i + 1)]);
  }
  EXPECT_THAT(InferSlices(positions), IsEmpty());
}

TEST(InferSlices, TakesACentimetreOfRounding) {
  PointCloud cloud = ToPointCloud(ScanOfRoom(1, 128));
  for (Eigen::Vector3d& p : cloud.positions) p = (p * 100.0).array().round() / 100.0;
  EXPECT_EQ(InferSlices(cloud.positions), cloud.slice_begin);
}

TEST(InferSlices, TakesPointsThatGoBackALittleWithinASweep) {
  RandomStream stream = NamedStream(1, "slices_test/jitter");
  PointCloud cloud = ToPointCloud(ScanOfRoom(4, 64));
  for (Eigen::Vector3d& p : cloud.positions) p.y() += DrawNormal(stream, 0.0, 0.02);  // along the tilt axis
  EXPECT_EQ(InferSlices(cloud.positions), cloud.slice_begin);
}

TEST(InferSlices, PassesOverNonFinitePoints) {
  PointCloud cloud = ToPointCloud(ScanOfRoom(1, 64));
  for (std::size_t i = 60; i < cloud.size(); i += 181) {
    cloud.positions[i].setConstant(std::numeric_limits<double>::quiet_NaN());
  }
  EXPECT_EQ(InferSlices(cloud.positions), cloud.slice_begin);
}

TEST(InferSlices, FindsThreeSlicesButNotTwo) {
  const PointCloud three = ToPointCloud(ScanOfRoom(1, 3));
  EXPECT_THAT(InferSlices(three.positions), ElementsAre(0, 181, 362));
  EXPECT_THAT(InferSlices(ToPointCloud(ScanOfRoom(1, 2)).positions), IsEmpty());
}

TEST(InferSlices, FindsNothingWithoutASweep) {
  EXPECT_THAT(InferSlices({}), IsEmpty());
  EXPECT_THAT(InferSlices({{1.0, 0.0, 0.0}}), IsEmpty());
  EXPECT_THAT(InferSlices(std::vector<Eigen::Vector3d>(1000, {1.0, 2.0, 3.0})), IsEmpty());
}

std::filesystem::path DataFolder() {
  const char* const data = std::getenv("ARIADNE_DATA");
  return data ? std::filesystem::path(data) : std::filesystem::path(ARIADNE_SOURCE_DIR) / "../shared/data";
}

/// Reads a uos file: centimetres, left-handed, x right, y up, z forward.
std::vector<Eigen::Vector3d> ReadUos(const std::filesystem::path& path) {
  std::ifstream file(path);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  std::vector<double> numbers;
  const char* const end = text.data() + text.size();
  for (const char* at = text.data(); at < end; ++at) {
    double number = 0.0;
    at = std::from_chars(at, end, number).ptr;  // stops at the blank behind it
    numbers.push_back(number);
  }
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3) {
    points.push_back(0.01 * Eigen::Vector3d(numbers[i + 2], -numbers[i], numbers[i + 1]));
  }
  return points;
}

TEST(InferSlices, FindsThe226SlicesOfTheRealHallway) {
  const std::filesystem::path folder = DataFolder() / "scans/hallway";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not there; set ARIADNE_DATA";
  std::vector<std::size_t> every_360th;
  for (std::size_t s = 0; s < 226; ++s) every_360th.push_back(360 * s);
  for (const char* const name : {"scan000.3d", "scan001.3d", "scan002.3d"}) {
    const auto positions_laser = ReadUos(folder / name);
    ASSERT_EQ(positions_laser.size(), 81'360u) << name;
    EXPECT_EQ(InferSlices(positions_laser), every_360th) << name;
  }
}

}  // namespace
}  // namespace ariadne::slam
