#include "experiments/metrics/scan_statistics.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "experiments/metrics/statistics.h"
#include "slam/geometry/box3.h"
#include "slam/search/kd_tree.h"

namespace ariadne::experiments {
namespace {

constexpr std::size_t kSamples = 1000;   // that tell the spacing
constexpr double kNear = 0.2;            // nearer points are usually the robot, or failures [m]
constexpr double kWorthTelling = 0.001;  // share of the points
constexpr double kNotByChance = 10.0;    // points at one range: the farthest ones of a small scan are not
constexpr double kSameRange = 1e-3;      // within it, ranges at the far end are one value: relative
constexpr double kManyTimesMedian = 100.0;  // a farthest point beyond this is probably no measurement

/// Distances from evenly chosen points to their nearest neighbours. Zero: the points stand in the file
/// twice.
std::vector<double> Spacings(const slam::PointCloud& cloud) {
  const slam::KdTree tree(cloud.positions);
  std::vector<double> spacings;
  for (std::size_t i = 0; i < cloud.size(); i += 1 + cloud.size() / kSamples) {
    std::array<slam::Neighbor, 2> nearest;
    if (tree.NearestK(cloud.positions[i], nearest) == 2)
      spacings.push_back(std::sqrt(nearest[1].squared_distance));
  }
  return spacings;
}

std::string FindSuspicious(const std::vector<double>& ranges, const ScanStatistics& s,
                           const std::vector<double>& spacings) {
  const auto share = [&](const auto& condition) {
    return static_cast<double>(std::count_if(ranges.begin(), ranges.end(), condition)) /
           static_cast<double>(ranges.size());
  };
  std::vector<std::string> found;
  const double near = share([](double r) { return r < kNear; });
  if (near > kWorthTelling) found.push_back(fmt::format("{:.1f} % nearer than {} m", 100.0 * near, kNear));
  const double far = share([&](double r) { return r > s.max_range * (1.0 - kSameRange); });
  if (far > kWorthTelling && far * static_cast<double>(ranges.size()) > kNotByChance) {
    found.push_back(
        fmt::format("{:.1f} % at {:.2f} m, the largest range: no-returns", 100.0 * far, s.max_range));
  }
  if (s.max_range > kManyTimesMedian * s.median_range)
    found.push_back(fmt::format("a range of {:.0f} m", s.max_range));
  const auto twice = std::count(spacings.begin(), spacings.end(), 0.0);
  if (twice > 0) {
    found.push_back(fmt::format("{:.1f} % repeated points",
                                100.0 * static_cast<double>(twice) / static_cast<double>(spacings.size())));
  }
  return fmt::format("{}", fmt::join(found, "; "));
}

}  // namespace

ScanStatistics MeasureScan(const slam::PointCloud& cloud_laser) {
  ScanStatistics s;
  s.points = cloud_laser.size();
  s.slices = cloud_laser.slice_begin.size();
  s.has_reflectance = !cloud_laser.reflectance.empty();
  if (cloud_laser.empty()) {
    s.suspicious = "no points";
    return s;
  }
  s.extent = slam::BoxAround(cloud_laser.positions).sizes();
  std::vector<double> ranges;
  for (const Eigen::Vector3d& p : cloud_laser.positions) ranges.push_back(p.norm());
  const auto [min, max] = std::minmax_element(ranges.begin(), ranges.end());
  s.min_range = *min;
  s.max_range = *max;
  s.median_range = Median(ranges);
  const std::vector<double> spacings = Spacings(cloud_laser);
  if (!spacings.empty()) s.median_spacing = Median(spacings);
  s.suspicious = FindSuspicious(ranges, s, spacings);
  return s;
}

}  // namespace ariadne::experiments
