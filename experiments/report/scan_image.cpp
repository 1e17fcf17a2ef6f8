#include "experiments/report/scan_image.h"

#include <algorithm>
#include <cmath>

#include "experiments/render/camera.h"
#include "experiments/render/color_map.h"
#include "experiments/render/point_view.h"
#include "experiments/report/model_pictures.h"
#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

/// Grey values without a few outliers at each end.
ValueRange ReflectanceRange(const slam::Scan& scan) {
  std::vector<double> values;
  for (const slam::LaserSweep& sweep : scan.sweeps) {
    if (sweep.reflectance.size() != sweep.ranges.size()) Fail("the scan has no reflectance to draw");
    for (std::size_t b = 0; b < sweep.ranges.size(); ++b) {
      if (std::isfinite(sweep.ranges[b])) values.push_back(sweep.reflectance[b]);
    }
  }
  return RobustRange(values);
}

}  // namespace

Image DistortedReflectance(const slam::Scan& scan) {
  if (scan.sweeps.empty()) Fail("the scan is empty: there is nothing to draw");
  const ValueRange range = ReflectanceRange(scan);
  const auto width = static_cast<int>(scan.sweeps.front().ranges.size());
  const auto height = static_cast<int>(scan.sweeps.size());
  const bool upwards = scan.sweeps.back().pitch >= scan.sweeps.front().pitch;
  Image image(width, height, kBlack);
  for (int y = 0; y < height; ++y) {
    const auto row = static_cast<std::size_t>(upwards ? height - 1 - y : y);
    const slam::LaserSweep& sweep = scan.sweeps[row];
    for (int x = 0; x < width; ++x) {
      const auto beam = static_cast<std::size_t>(width - 1 - x);  // beam 0 looks to the right
      if (!std::isfinite(sweep.ranges[beam])) continue;
      image.pixels[image.IndexOf(x, y)] = ColorAt(ColorMap::kGray, range.Share(sweep.reflectance[beam]));
    }
  }
  return image;
}

Image CorrectedReflectance(const slam::Scan& scan, int width, int height, double field_of_view) {
  const slam::PointCloud cloud_laser = slam::ToPointCloud(scan);
  if (cloud_laser.reflectance.size() != cloud_laser.size()) Fail("the scan has no reflectance to draw");
  const std::vector<double> values(cloud_laser.reflectance.begin(), cloud_laser.reflectance.end());
  const Camera camera = AheadCamera({width, height}, field_of_view);
  return RenderPoints(ColoredByValue(cloud_laser.positions, values, ColorMap::kGray, RobustRange(values)),
                      camera, {.background = kBlack});
}

}  // namespace ariadne::experiments
