#pragma once

#include <string>

#include "control/approach_plan.h"
#include "experiments/exploration/scan_loop_area.h"
#include "experiments/mission/drive_path.h"
#include "experiments/mission/ground_map.h"
#include "experiments/mission/roomy_way.h"
#include "planning/view/view_planner.h"
#include "slam/map/occupancy_grid.h"
#include "slam/mapper.h"

namespace ariadne::experiments {

/// The view planner for a robot that errs: its half width passes wherever it may get through, places to
/// scan leave room to turn on the spot, which takes half its diagonal, and slits that noise leaves do not
/// count.
planning::ViewPlannerOptions RobotPlannerOptions();

/// The paper's choice among candidates, for a robot that must get there: with the clearances of `robot`.
planning::ViewPlannerOptions PaperRobotPlannerOptions(const planning::ViewPlannerOptions& robot);

/// Registration for scans that see each side of a thin wall by itself, from a guess that errs little: what
/// the surfaces hardly hold stays where odometry has it, in the alignments and in the graph.
slam::MapperOptions RobotMapperOptions();

/// What may be free although nothing was seen at its height: windows are wide, and walls count as
/// obstacles.
ScanLoopAreaOptions RobotAreaOptions();

/// Obstacles up to the top of the robot, of what scans show nearby.
slam::OccupancyGridOptions RobotObstacleOptions();

/// Paths keep from what the map shows what the map, the localization and the controller err, and half of
/// that where there is no more room; giving way leaves what the scanners err.
planning::PathOptions RobotPathOptions();
DriveOptions RobotDriveOptions();

/// How the robot gets to a view.
enum class DriveBy {
  kPath,           // planned for its rectangle
  kApproach,       // the paper's controller and its two fallback behaviours (5.2)
  kApproachFirst,  // a path where none of these is free
};

/// After which a mission ends, whatever is left to see.
struct MissionLimits {
  int max_scans = 200;
  double max_time = 7200.0;
  double max_distance = 2000.0;
  std::string fence;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("max_scans", self.max_scans, Unit(""), Range{1, 100000}, "taken, the first one included");
    visit("max_time", self.max_time, Unit("s"), Range{0.0, 1e9}, "by the robot's clock");
    visit("max_distance", self.max_distance, Unit("m"), Range{0.0, 1e9}, "driven, by odometry");
    visit("fence", self.fence,
          "corners of an area that the robot does not leave, in the map, whose origin is where the robot's "
          "first pose says; x0 y0, x1 y1, ... [m]; empty: none");
  }
};

/// What the mission does when a step fails.
struct MissionPatience {
  int targets = 5;
  int blocked = 6;
  int unregistered = 3;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("targets", self.targets, Unit(""), Range{1, 1000},
          "views that a path is looked for to, the best first (5.2), before the robot takes the way of a "
          "disc");
    visit("blocked", self.blocked, Unit(""), Range{1, 1000},
          "drives in a row that end at an obstacle near one place, after which the robot is stuck; after "
          "half as many it goes back the way that it came");
    visit("unregistered", self.unregistered, Unit(""), Range{1, 1000},
          "scans in a row that cannot be registered, after which the robot is lost; before, it drives back "
          "to "
          "where it was sure");
  }
};

struct MissionOptions {
  slam::MapperOptions mapper = RobotMapperOptions();
  ScanLoopAreaOptions area = RobotAreaOptions();
  slam::OccupancyGridOptions obstacles = RobotObstacleOptions();
  ClearOptions clear;
  std::string heights = "1.5";
  planning::ViewPlannerOptions planner = RobotPlannerOptions();
  DriveBy drive_by = DriveBy::kPath;
  control::ApproachPlanOptions approach;
  planning::PathOptions path = RobotPathOptions();
  RoomOptions room;
  double max_leg = 20.0;
  DriveOptions drive = RobotDriveOptions();
  MissionLimits limits;
  MissionPatience patience;
  bool return_to_start = false;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("mapper", self.mapper, "how scans are registered; odometry is the first guess");
    visit("area", self.area, "what is known to be free");
    visit("obstacles", self.obstacles, "what stands in the way, as high as the robot");
    visit("clear", self.clear, "where nothing stands in the way that no scan has met");
    visit("heights", self.heights,
          "of the slices [m]: a, b, ... Each is planned in by itself, and of their views that with the "
          "highest value is taken; the paper has one to five, 1.5 in its example (4.2)");
    visit("planner", self.planner, "where to scan next");
    visit(
        "drive_by", self.drive_by,
        "how the robot gets there: by path, or by the paper's approach, or by path where that is not free");
    visit("approach", self.approach, "the paper's controller and its two fallback behaviours (5.1, 5.2)");
    visit("path", self.path, "how to get there, for the robot's rectangle");
    visit("room", self.room, "how far such a path keeps off things where it can");
    visit(
        "max_leg", self.max_leg, Unit("m"), Range{0.1, 1e6},
        "driven at most; a longer way is left off there for a scan towards its rest, and planned anew. By "
        "odometry alone (drive.localize.enabled=false) 4 m are right: after 8 m it errs by 20 to 30 cm");
    visit("drive", self.drive, "how a path is driven");
    visit("limits", self.limits, "after which the mission ends");
    visit("patience", self.patience, "what is tried when a step fails");
    visit("return_to_start", self.return_to_start, "drive back to where the robot started, at the end");
  }
};

/// The loop of 2003: the queue of simultaneous matching with its metric, the planner's printed constants,
/// the controller and its behaviours, odometry alone while driving.
MissionOptions PaperMissionOptions();

}  // namespace ariadne::experiments

template <>
struct ariadne::EnumNames<ariadne::experiments::DriveBy> {
  static constexpr std::array<std::string_view, 3> value = {"path", "approach", "approach_first"};
};
