#include "drivers/simulated/world.h"

#include <algorithm>
#include <cmath>

#include "drivers/simulated/solids.h"
#include "slam/base/error.h"

namespace ariadne::drivers {

void RequireSound(const Motion& motion, const std::string& name) {
  if (motion.times.size() != motion.T_map_body.size()) {
    Fail("{}: the motion has {} times, but {} poses", name, motion.times.size(), motion.T_map_body.size());
  }
  for (std::size_t i = 0; i < motion.times.size(); ++i) {
    if (!std::isfinite(motion.times[i]) || !slam::IsFinite(motion.T_map_body[i])) {
      Fail("{}: key frame {} of the motion is not finite", name, i);
    }
    if (i > 0 && motion.times[i] <= motion.times[i - 1]) {
      Fail("{}: the times of the motion must ascend, but {} s follows {} s", name, motion.times[i],
           motion.times[i - 1]);
    }
  }
}

slam::Pose3 PoseAt(const Motion& motion, double time) {
  if (motion.times.empty()) return {};
  const auto next = std::ranges::upper_bound(motion.times, time);
  if (next == motion.times.begin()) return motion.T_map_body.front();
  if (next == motion.times.end()) return motion.T_map_body.back();
  const std::size_t i = static_cast<std::size_t>(next - motion.times.begin());
  const slam::Pose3& from = motion.T_map_body[i - 1];
  const slam::Pose3& to = motion.T_map_body[i];
  const double share = (time - motion.times[i - 1]) / (motion.times[i] - motion.times[i - 1]);
  return {from.rotation.slerp(share, to.rotation),
          from.translation + share * (to.translation - from.translation)};
}

TriangleMesh MeshAt(const Body& body, double time) {
  if (body.motion.times.empty()) return body.mesh_body;  // its frame is the map's, to the last digit
  return Moved(body.mesh_body, PoseAt(body.motion, time));
}

}  // namespace ariadne::drivers
