#pragma once

#include <vector>

#include "slam/base/options.h"
#include "slam/geometry/pose3.h"
#include "slam/scan/point_cloud.h"

namespace ariadne::experiments {

/// The built-in data: scans of a simulated office (drivers/simulated/box_world.h), which need no files.
///
/// The robot drives through the stops of OfficeTour(); the laser is 1 m above the floor, which tilts it a
/// little at each stop. Each motion is measured by an odometry that errs in the plane. Every beam is cast
/// exactly, while the tilt runs on, and errs in range. All draws come from streams of their own, named
/// after what they disturb.
struct OfficeScanOptions {
  int scans = 8;
  int beams = 181;
  int slices = 256;
  double range_sigma = 0.005;
  double odometry_sigma = 0.05;
  double heading_sigma = 0.03;
  double tilt_sigma = 0.005;
  int seed = 1;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("scans", self.scans, Unit(""), Range{1, 8}, "stops along the tour");
    visit("beams", self.beams, Unit("per slice"), Range{2, 721}, "181, 361 or 721 on the device (2.2)");
    visit("slices", self.slices, Unit(""), Range{1, 4096}, "128 or 256 on the device (2.2)");
    visit("range_sigma", self.range_sigma, Unit("m"), Range{0.0, 1.0},
          "LMS-200: 5 mm (specification, 9.5)");
    visit("odometry_sigma", self.odometry_sigma, Unit("m"), Range{0.0, 10.0},
          "error of x and y per motion");
    visit("heading_sigma", self.heading_sigma, Unit("rad"), Range{0.0, 3.0},
          "error of the heading per motion");
    visit("tilt_sigma", self.tilt_sigma, Unit("rad"), Range{0.0, 1.0},
          "roll and pitch of the floor at a stop");
    visit("seed", self.seed, Unit(""), Range{0, 2147483647}, "of all errors");
  }
};

/// Where the laser really is at each stop.
std::vector<slam::Pose3> TrueLaserPoses(const OfficeScanOptions& options);

/// Where odometry puts it, starting at the true first pose.
std::vector<slam::Pose3> OdometryPoses(const OfficeScanOptions& options);

/// The scan at one stop, in its laser frame, organized.
slam::PointCloud ScanOffice(const OfficeScanOptions& options, std::size_t stop);

}  // namespace ariadne::experiments
