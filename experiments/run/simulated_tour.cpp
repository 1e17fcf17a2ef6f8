#include "experiments/run/simulated_tour.h"

#include "experiments/run/data_path.h"

namespace ariadne::experiments {
namespace {

drivers::Tour TourOf(const TourOptions& options) {
  return {drivers::ParseWaypoints(options.waypoints, "input.tour.waypoints"), options.spacing,
          static_cast<std::size_t>(options.scans)};
}

/// The world with the robot at the beginning of the tour.
drivers::World LoadTourWorld(const TourOptions& options) {
  drivers::World world = drivers::LoadWorld(ExpandDataPath(options.world).string(), options.geometry);
  world.T_map_start = drivers::StartOf(TourOf(options));
  return world;
}

drivers::SimulatedBaseOptions WithNoise(drivers::SimulatedBaseOptions base, double factor) {
  base.wheels.radius_spread *= factor;
  base.wheels.track_spread *= factor;
  base.wheels.slip *= factor;
  base.odometry.wheel_noise *= factor;
  base.odometry.radius_uncertainty *= factor;
  base.odometry.track_uncertainty *= factor;
  return base;
}

std::vector<drivers::TourStop> Drive(const drivers::World& world, const TourOptions& options) {
  drivers::SimulatedBase base(world, WithNoise(options.base, options.odometry_noise),
                              static_cast<std::uint64_t>(options.seed));
  return drivers::DriveTour(base, TourOf(options), drivers::AisScanDuration(options.scanner));
}

}  // namespace

SimulatedTour::SimulatedTour(const TourOptions& options) : SimulatedTour(options, LoadTourWorld(options)) {}

SimulatedTour::SimulatedTour(const TourOptions& options, drivers::World world)
    : options_(options),
      T_base_laser_(drivers::AisMounting(options.scanner).T_base_laser),
      scene_(std::move(world)),
      stops_(Drive(scene_.world(), options)) {}

slam::Pose3 SimulatedTour::T_map_laser_true(std::size_t i) const {
  return slam::ToPose3(stops_[i].T_map_base_true) * T_base_laser_;
}

slam::Pose3 SimulatedTour::T_odom_laser(std::size_t i) const {
  const slam::Pose2 since_start = stops_[0].odometry.T_odom_base.Inverse() * stops_[i].odometry.T_odom_base;
  return slam::ToPose3(stops_[0].T_map_base_true * since_start) * T_base_laser_;
}

slam::Scan SimulatedTour::TakeScan(std::size_t i, const Parallel& parallel) const {
  slam::Scan scan =
      drivers::TakeAisScan(scene_, slam::ToPose3(stops_[i].T_map_base_true), stops_[i].time,
                           options_.scanner, static_cast<std::uint64_t>(options_.seed), i, parallel);
  scan.odometry = stops_[i].odometry;
  return scan;
}

}  // namespace ariadne::experiments
