#include "experiments/mission/mission_options.h"

namespace ariadne::experiments {

planning::ViewPlannerOptions RobotPlannerOptions() {
  planning::ViewPlannerOptions options;
  options.robot_radius = 0.31;
  options.view_clearance = 0.58;
  options.free_space.resolution = 0.05;
  options.candidates.wall_clearance = 0.5;
  options.min_overlap = 0.3;
  options.min_opening = 0.3;
  return options;
}

planning::ViewPlannerOptions PaperRobotPlannerOptions(const planning::ViewPlannerOptions& robot) {
  planning::ViewPlannerOptions paper = planning::PaperViewPlannerOptions();
  paper.robot_radius = robot.robot_radius;
  paper.view_clearance = robot.view_clearance;
  paper.free_space = robot.free_space;
  paper.candidates = robot.candidates;
  return paper;
}

slam::MapperOptions RobotMapperOptions() {
  slam::MapperOptions options;
  options.registration.method = slam::MatchMethod::kGraph;
  options.icp.one_sided = true;
  options.icp.guess_share = 0.001;
  options.registration.graph.further_edges = 2;
  options.registration.graph.odometry_position = 0.02;
  options.registration.graph.odometry_angle = 0.01;
  options.registration.graph.floor_height = 0.01;
  options.registration.graph.floor_tilt = 0.005;
  return options;
}

ScanLoopAreaOptions RobotAreaOptions() {
  ScanLoopAreaOptions options;
  options.max_gap = 90.0;
  options.sparse.max_spacing = 0.15;
  return options;
}

planning::PathOptions RobotPathOptions() {
  planning::PathOptions options;
  options.footprint.margin = 0.08;
  return options;
}

DriveOptions RobotDriveOptions() {
  DriveOptions options;
  options.avoid.robot.margin = 0.03;
  options.avoid.creep = 0.02;
  return options;
}

slam::OccupancyGridOptions RobotObstacleOptions() {
  slam::OccupancyGridOptions options;
  options.min_height = 0.1;
  options.max_height = 1.2;
  options.max_range = 8.0;
  options.resolution = 0.03;
  options.most_against = 0.8;
  options.doubt = 0.24;
  return options;
}

MissionOptions PaperMissionOptions() {
  MissionOptions options;
  options.mapper = slam::MapperOptions();
  options.mapper.reduce.method = slam::ReduceMethod::kSlices;
  options.mapper.icp.metric = slam::Metric::kPointToPoint;
  options.mapper.icp.max_distance = 0.25;
  options.mapper.icp.start_distance = 0.0;
  options.mapper.icp.kernel = slam::RobustKernel::kNone;
  options.planner = PaperRobotPlannerOptions(options.planner);
  options.drive_by = DriveBy::kApproach;
  options.drive.localize.enabled = false;
  return options;
}

}  // namespace ariadne::experiments
