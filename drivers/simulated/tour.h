#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "drivers/simulated/simulated_base.h"

namespace ariadne::drivers {

/// A way through a world, and where the robot stops on it to scan.
struct Tour {
  std::vector<Eigen::Vector2d> waypoints_map;  // [m]
  double spacing = 2.0;                        // between stops, along the way [m]
  std::size_t max_stops = 1000;                // the first stop is at the first waypoint
};

/// Reads "x y, x y, ..." [m]; Error with what is wrong, naming the text by `where`.
std::vector<Eigen::Vector2d> ParseWaypoints(const std::string& text, const std::string& where);

/// Where on the tour the robot stops.
std::vector<Eigen::Vector2d> StopsOf(const Tour& tour);

/// The pose at which a robot begins the tour: at its first waypoint, towards the next.
slam::Pose2 StartOf(const Tour& tour);

/// A stop as it came about.
struct TourStop {
  double time = 0.0;  // when the wheels stood, and a scan can begin [s]
  slam::Pose2 T_map_base_true;
  slam::Odometry odometry;
};

/// Drives the tour as a person with a joystick does, who sees where the robot is: turns on the spot, drives
/// straight on, stops. Only what the wheels do by themselves (slip, their true radii) lets odometry and
/// truth differ. Each stop lasts `pause` [s]: a scan. Error where the world is in the way.
std::vector<TourStop> DriveTour(SimulatedBase& base, const Tour& tour, double pause);

}  // namespace ariadne::drivers
