#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "experiments/mission/mission_map.h"

namespace ariadne::experiments {

/// What is to be driven next, and why.
struct PlannedDrive {
  std::optional<planning::View> view;    // none: back to a place where the robot has been
  std::vector<slam::Pose2> path_map;     // from where the robot stands; its frame, and how it is turned
  std::size_t height = 0;                // in whose slice the view was planned
  std::size_t rank = 0;                  // 0: the best of the views
  bool leg_only = false;                 // the path ends before the view
  bool of_disc = false;                  // the rectangle has no path; this is a disc's
  double margin = 0.0;                   // that the path keeps beside the rectangle [m]
  std::size_t retraced = 0;              // poses at the path's start: back the way that the robot came
  std::optional<ApproachTask> approach;  // the path is what it is expected to drive
};

/// What planning looks at.
struct Surroundings {
  std::vector<std::vector<planning::LabelledPolygon>> areas;  // by height
  std::vector<Eigen::Vector2d> obstacles_map;
  std::vector<Eigen::Vector2d> unclear_map;  // where something may stand that no scan has met
  std::vector<slam::Pose2> T_map_scans;      // of the scanner
  std::vector<slam::Pose2> T_map_stops;      // of the robot, where scans show something
  std::vector<slam::Pose2> trail_map;        // driven last, to where the robot stands
};

Surroundings SurroundingsOf(MissionMap& map, std::span<const slam::Pose2> trail_map);

}  // namespace ariadne::experiments
