#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "drivers/robot.h"
#include "experiments/mission/next_drive.h"

namespace ariadne::experiments {

/// Why a mission ended.
enum class MissionEnd {
  kNothingLeft,  // no view that can be reached is worth a scan any more
  kScanLimit,
  kTimeLimit,
  kDistanceLimit,
  kStuck,     // drive after drive ended at an obstacle
  kLost,      // scan after scan could not be registered
  kRejected,  // a plan was not approved
  kStopped    // by the user or an emergency stop
};

/// A sentence for each.
std::string_view Describe(MissionEnd end);

/// A scan, and what led to it.
struct MissionStop {
  double time = 0.0;                    // of the robot's clock, when it was taken [s]
  double distance = 0.0;                // driven up to here, by odometry [m]
  std::optional<planning::View> view;   // that the drive was for; none for the first scan, and on ways back
  DriveEnd drive = DriveEnd::kArrived;  // how the drive here ended
  std::string reason;                   // where that was given up
  bool leg_only = false;                // it was a part of the way to the view
  bool of_disc = false;
  std::vector<slam::Pose2> driven_map;  // from the stop before, as the robot took itself to be
  slam::Pose2 T_map_base_guess;         // as it came here
  slam::Pose2 T_map_base;               // registered, as it was then
  bool registered = false;
  std::string message;            // of the registration
  double unseen = 0.0;            // edges of the area at the first height that nobody has looked behind [m]
  double free_area = 0.0;         // known to be free there [m^2]
  int views_left = 0;             // that the unseen edges ask for, at a guess
  double matching_seconds = 0.0;  // times are not deterministic
  double planning_seconds = 0.0;
  double driving_seconds = 0.0;
};

struct MissionResult {
  MissionEnd end = MissionEnd::kNothingLeft;
  std::vector<MissionStop> stops;
  std::vector<slam::PosedCloud> scans;  // where they came to lie
  std::vector<bool> registered;
  std::vector<Eigen::Vector2d> path_map;        // driven, by odometry between the scans
  std::vector<planning::LabelledPolygon> area;  // at the first height
  std::vector<Eigen::Vector2d> obstacles_map;   // that the robot knew at the end
  double time = 0.0;                            // of the robot's clock, at the end [s]
  double distance = 0.0;                        // by odometry [m]
  bool returned = false;                        // it was to return to the start, and did
};

/// Who watches a mission; each may be empty.
struct MissionEvents {
  std::function<void(const std::string&)> on_status;  // what is done now
  /// A scan has been registered. It and the map are complete; what is told here is on the disk before the
  /// robot drives on.
  std::function<void(const MissionStop&, const MissionMap&)> on_stop;
  std::function<void(const PlannedDrive&, const Surroundings&)> on_plan;
  std::function<bool(const PlannedDrive&)> approve;  // false ends the mission
  std::function<bool()> stop;                        // true: the wheels stop, and the mission ends
};

/// The six steps of the paper (Sec. 1): acquisition, registration, planning and driving in turns, until
/// nothing is left to see or a limit is reached; then the integration of all scans. A mission only knows
/// the robot: the same answers of the robot give the same bytes, but for the seconds of computing.
///
/// A step that fails has a next step. A scan that cannot be registered shows nothing, and the robot drives
/// back to where it was registered last, and scans there. A drive that ends at an obstacle is followed by a
/// scan where the robot has come to; the obstacle is in the way of all later plans, and a target that was
/// tried twice is left alone.
MissionResult RunMission(drivers::Robot& robot, const MissionOptions& options, std::uint64_t seed,
                         const MissionEvents& events = {});

}  // namespace ariadne::experiments
