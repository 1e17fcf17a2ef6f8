#include "experiments/run/office_scans.h"

#include <fmt/format.h>

#include "drivers/simulated/box_world_scan.h"
#include "slam/base/random.h"
#include "slam/geometry/pose2.h"

namespace ariadne::experiments {
namespace {

constexpr double kLaserHeight = 1.0;  // [m]

std::uint64_t Seed(const OfficeScanOptions& options) { return static_cast<std::uint64_t>(options.seed); }

}  // namespace

std::vector<slam::Pose3> TrueLaserPoses(const OfficeScanOptions& options) {
  RandomStream tilt = NamedStream(Seed(options), "office/tilt");
  std::vector<slam::Pose3> T_map_laser;
  for (const slam::Pose2& stop : drivers::OfficeTour()) {
    if (T_map_laser.size() == static_cast<std::size_t>(options.scans)) break;
    slam::Pose3::Tangent tilted = slam::Pose3::Tangent::Zero();
    tilted(2) = kLaserHeight;
    tilted(3) = DrawNormal(tilt, 0.0, options.tilt_sigma);
    tilted(4) = DrawNormal(tilt, 0.0, options.tilt_sigma);
    T_map_laser.push_back(slam::ToPose3(stop) * slam::Pose3::Exp(tilted));
  }
  return T_map_laser;
}

std::vector<slam::Pose3> OdometryPoses(const OfficeScanOptions& options) {
  RandomStream wheels = NamedStream(Seed(options), "office/odometry");
  const std::vector<slam::Pose3> truth = TrueLaserPoses(options);
  std::vector<slam::Pose3> T_odom_laser{truth.front()};
  for (std::size_t i = 1; i < truth.size(); ++i) {
    slam::Pose3::Tangent error = slam::Pose3::Tangent::Zero();
    error(0) = DrawNormal(wheels, 0.0, options.odometry_sigma);
    error(1) = DrawNormal(wheels, 0.0, options.odometry_sigma);
    error(5) = DrawNormal(wheels, 0.0, options.heading_sigma);
    const slam::Pose3 motion = truth[i - 1].Inverse() * truth[i];
    T_odom_laser.push_back(T_odom_laser.back() * motion * slam::Pose3::Exp(error));
  }
  return T_odom_laser;
}

slam::PointCloud ScanOffice(const OfficeScanOptions& options, std::size_t stop) {
  const drivers::BoxScanSettings settings{
      .beams = options.beams, .slices = options.slices, .range_sigma = options.range_sigma};
  RandomStream range = NamedStream(Seed(options), fmt::format("office/range/{}", stop));
  return slam::ToPointCloud(
      drivers::ScanBoxWorld(drivers::MakeOffice(), TrueLaserPoses(options).at(stop), settings, range));
}

}  // namespace ariadne::experiments
