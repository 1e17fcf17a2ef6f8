#pragma once

#include <string>
#include <vector>

#include "drivers/simulated/ray_scene.h"
#include "drivers/simulated/simulated_robot.h"
#include "experiments/mission/drive_path.h"

namespace ariadne::experiments {

/// What a robot that looks where it goes could have done about a contact with what walks.
struct ContactVerdict {
  bool needless = false;  // had it braked in time, it would not have been touched
  /// It could have stood by then: when it had to put on the brakes for that, a scanner had the body in
  /// view, and saw it walk for as long as it takes to believe it (`moving.least`).
  bool foreseeable = false;
};

ContactVerdict JudgeContact(const drivers::Collision& contact,
                            const std::vector<drivers::TruePose>& path_true, const drivers::RayScene& scene,
                            const drivers::SimulatedRobotOptions& robot, const DriveOptions& drive);

/// Whether a scanner that a driving robot looks around with (5.3) has a body of the world in view: the
/// safety scanners, and the 3D scanner in horizontal mode, 180 deg each, one ray each half degree.
bool HasInView(const drivers::RayScene& scene, const slam::Pose2& T_map_base, double time,
               const std::string& body, const drivers::SimulatedRobotOptions& robot);

}  // namespace ariadne::experiments
