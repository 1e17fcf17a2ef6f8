#include "experiments/mission/mission_options.h"

namespace ariadne::experiments {

ScanLoopAreaOptions RobotAreaOptions() {
  ScanLoopAreaOptions options;
  options.max_gap = 90.0;
  return options;
}

slam::OccupancyGridOptions RobotObstacleOptions() {
  slam::OccupancyGridOptions options;
  options.min_height = 0.1;
  options.max_height = 1.2;
  options.max_range = 8.0;
  return options;
}

}  // namespace ariadne::experiments
