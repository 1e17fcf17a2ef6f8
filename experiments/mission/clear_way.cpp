#include "experiments/mission/clear_way.h"

namespace ariadne::experiments {
double LengthOf(std::span<const slam::Pose2> poses) {
  double length = 0.0;
  for (std::size_t i = 1; i < poses.size(); ++i)
    length += (poses[i].translation - poses[i - 1].translation).norm();
  return length;
}

std::size_t ClearPoses(std::span<const slam::Pose2> path, const planning::FreeSpace& space,
                       const planning::FootprintOptions& footprint) {
  const planning::Footprint robot(footprint);
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (!robot.IsFree(space, path[i])) return i;
  }
  return path.size();
}

}  // namespace ariadne::experiments
