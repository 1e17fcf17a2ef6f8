#pragma once

#include <span>
#include <string>
#include <vector>

#include "slam/base/options.h"
#include "slam/geometry/pose2.h"
#include "slam/scan/point_cloud.h"

namespace ariadne::slam {

struct HorizontalSliceOptions {
  double height = 1.5;
  double half_thickness = 0.02;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("height", self.height, Unit("m"), Range{-1000.0, 1000.0},
          "of the slice, as z of the map; 150 cm is the paper's example (4.2), where the floor is z = 0");
    visit("half_thickness", self.half_thickness, Unit("m"), Range{1e-4, 10.0},
          "above and below the height; the paper's 2 cm (4.2)");
  }
};

/// What a scan saw at a height, as seen from above.
struct HorizontalSlice {
  std::string name;                         // the scan's
  Pose2 T_map_scan;                         // where the laser stood, x to where it looked
  std::vector<Eigen::Vector2d> points_map;  // in the order of the cloud [m]
};

/// The points of a scan at a height (Sec. 4.2). Error for a coordinate or pose that is NaN or infinite.
HorizontalSlice SliceAt(const PosedCloud& scan, const HorizontalSliceOptions& options);

/// A slice per scan, also where a scan has no points there.
std::vector<HorizontalSlice> SlicesAt(std::span<const PosedCloud> scans,
                                      const HorizontalSliceOptions& options);

/// Throws an Error that names the scan where a coordinate or the pose is NaN or infinite.
void RequireFinite(const PosedCloud& scan);

}  // namespace ariadne::slam
