#include "experiments/mission/planned_drive.h"

#include <utility>

namespace ariadne::experiments {

Surroundings SurroundingsOf(MissionMap& map, std::span<const slam::Pose2> trail_map) {
  Surroundings around;
  for (std::size_t h = 0; h < map.height_count(); ++h) around.areas.push_back(map.Area(h));
  Ground ground = map.LookAtGround();
  around.obstacles_map = std::move(ground.obstacles_map);
  around.unclear_map = std::move(ground.unclear_map);
  around.T_map_scans = map.T_map_scans();
  for (std::size_t i = 0; i < map.size(); ++i) {
    if (map.registered(i)) around.T_map_stops.push_back(map.T_map_base(i));
  }
  around.trail_map.assign(trail_map.begin(), trail_map.end());
  return around;
}

}  // namespace ariadne::experiments
