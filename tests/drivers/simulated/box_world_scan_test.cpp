#include "drivers/simulated/box_world_scan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "slam/geometry/angles.h"
#include "slam/geometry/so3.h"

namespace ariadne::drivers {
namespace {

using slam::LaserSweep;
using slam::PointCloud;
using slam::Pose3;
using slam::Scan;

/// In the left office, a little askew.
Pose3 LaserInOffice() { return {slam::ExpSo3({0.02, -0.03, 1.2}), {3.1, 2.6, 1.0}}; }

BoxScanSettings SmallScan(double range_sigma = 0.0) {
  BoxScanSettings settings;
  settings.beams = 91;
  settings.slices = 64;
  settings.range_sigma = range_sigma;
  return settings;
}

Scan ScanWith(const BoxScanSettings& settings, std::uint64_t seed = 1) {
  RandomStream noise = NamedStream(seed, "box_world_scan_test/range");
  return ScanBoxWorld(MakeOffice(), LaserInOffice(), settings, noise);
}

/// Distance from a point to the surface of a box.
double DistanceToSurface(const slam::Box3& box, const Eigen::Vector3d& p) {
  if (!box.contains(p)) return box.exteriorDistance(p);
  return std::min((p - box.min()).minCoeff(), (box.max() - p).minCoeff());
}

double DistanceToSurfaces(const BoxWorld& world, const Eigen::Vector3d& p) {
  double nearest = 1e9;
  for (const slam::Box3& box : world.solids) nearest = std::min(nearest, DistanceToSurface(box, p));
  return nearest;
}

TEST(ScanBoxWorld, PutsEachPointOnASurface) {
  for (const int beams : {91, 181, 361}) {
    BoxScanSettings settings = SmallScan();
    settings.beams = beams;
    settings.slices = 16;
    const PointCloud cloud = ToPointCloud(ScanWith(settings));
    ASSERT_EQ(cloud.size(), static_cast<std::size_t>(beams) * 16);
    for (const Eigen::Vector3d& p : cloud.positions) {
      EXPECT_LT(DistanceToSurfaces(MakeOffice(), LaserInOffice() * p), 2e-6)
          << "ranges are rounded to float";
    }
  }
}

TEST(ScanBoxWorld, SeesWhatIsNearestInItsDirection) {
  for (const Eigen::Vector3d& p : ToPointCloud(ScanWith(SmallScan())).positions) {
    const Eigen::Vector3d direction = LaserInOffice().rotation * p.normalized();
    const auto distance = CastRay(MakeOffice(), LaserInOffice().translation, direction);
    ASSERT_TRUE(distance.has_value());
    // Beams that graze an edge go either way by the rounding of the point.
    EXPECT_TRUE(std::abs(*distance - p.norm()) < 1e-5 || *distance > p.norm());
  }
}

TEST(ScanBoxWorld, HasTheApertureAndTheTimesOfThePaper) {
  const Scan scan = ScanWith({});
  EXPECT_EQ(scan.sweeps.size(), 256u);
  EXPECT_EQ(ToPointCloud(scan).size(), 46'336u);
  EXPECT_DOUBLE_EQ(scan.scanner.angle_step, slam::RadFromDeg(1.0));
  EXPECT_EQ(scan.scanner.turns_per_sweep, 1);
  const LaserSweep& last = scan.sweeps.back();
  EXPECT_NEAR(last.stamp + scan.scanner.turn_period, 3.41, 0.01) << "3.4 s";
  const double end = last.pitch + last.pitch_rate * scan.scanner.turn_period;
  EXPECT_NEAR(slam::DegFromRad(scan.sweeps[0].pitch), -55.0, 1e-9);
  EXPECT_NEAR(slam::DegFromRad(end), 65.0, 1e-9);
}

TEST(ScanBoxWorld, TurnsTheMirrorMoreOftenForFinerBeams) {
  BoxScanSettings settings = SmallScan();
  settings.slices = 4;
  for (const auto& [beams, turns] : {std::pair(181, 1), {361, 2}, {721, 4}}) {
    settings.beams = beams;
    const Scan scan = ScanWith(settings);
    EXPECT_EQ(scan.scanner.turns_per_sweep, turns);
    EXPECT_NEAR(scan.sweeps[1].stamp - scan.sweeps[0].stamp, turns / 75.0, 1e-12);
  }
}

TEST(ScanBoxWorld, AddsNormalNoiseToTheRanges) {
  constexpr double kSigma = 0.02;
  const Scan exact = ScanWith(SmallScan()), noisy = ScanWith(SmallScan(kSigma));
  double sum = 0.0, sum_squared = 0.0;
  int beyond_two_sigma = 0, n = 0;
  for (std::size_t s = 0; s < exact.sweeps.size(); ++s) {
    for (std::size_t b = 0; b < exact.sweeps[s].ranges.size(); ++b, ++n) {
      const double z = static_cast<double>(noisy.sweeps[s].ranges[b] - exact.sweeps[s].ranges[b]) / kSigma;
      sum += z;
      sum_squared += z * z;
      beyond_two_sigma += std::abs(z) > 2.0;
    }
  }
  ASSERT_EQ(n, 91 * 64);
  EXPECT_NEAR(sum, 0.0, 4.0 * std::sqrt(n));
  EXPECT_NEAR(sum_squared, n, 4.0 * std::sqrt(2.0 * n)) << "chi-square of n degrees of freedom";
  EXPECT_NEAR(beyond_two_sigma, 0.0455 * n, 4.0 * std::sqrt(0.0455 * n));
}

TEST(ScanBoxWorld, IsTheSameForTheSameNoise) {
  const auto ranges = [](std::uint64_t seed) {
    std::vector<float> all;
    for (const LaserSweep& sweep : ScanWith(SmallScan(0.01), seed).sweeps) {
      all.insert(all.end(), sweep.ranges.begin(), sweep.ranges.end());
    }
    return all;
  };
  EXPECT_EQ(ranges(1), ranges(1));
  EXPECT_NE(ranges(1), ranges(2));
}

TEST(ScanBoxWorld, HasNoReturnFromBeyondItsRange) {
  BoxScanSettings settings = SmallScan();
  settings.max_range = 2.0;
  const Scan near = ScanWith(settings), all = ScanWith(SmallScan());
  int without_return = 0;
  for (std::size_t s = 0; s < all.sweeps.size(); ++s) {
    for (std::size_t b = 0; b < all.sweeps[s].ranges.size(); ++b) {
      const bool in_range = all.sweeps[s].ranges[b] < 2.0F;
      EXPECT_EQ(std::isfinite(near.sweeps[s].ranges[b]), in_range);
      without_return += !in_range;
    }
  }
  EXPECT_GT(without_return, 100);
  EXPECT_EQ(ToPointCloud(near).size(), static_cast<std::size_t>(91 * 64 - without_return));
  RandomStream noise = NamedStream(1, "");
  EXPECT_TRUE(ToPointCloud(ScanBoxWorld({}, Pose3(), settings, noise)).empty())
      << "nor from an empty world";
}

TEST(ScanBoxWorld, DrawsNoiseForEveryBeamAlike) {
  // So that what one beam sees does not change the noise of the others.
  BoxScanSettings settings = SmallScan(0.01);
  RandomStream of_office = NamedStream(1, "a"), of_nothing = NamedStream(1, "a");
  ScanBoxWorld(MakeOffice(), LaserInOffice(), settings, of_office);
  ScanBoxWorld({}, LaserInOffice(), settings, of_nothing);
  EXPECT_EQ(of_office(), of_nothing());
}

}  // namespace
}  // namespace ariadne::drivers
