#pragma once

#include <functional>
#include <memory>
#include <string>

#include "drivers/simulated/simulated_robot.h"
#include "experiments/exploration/floor_cover.h"
#include "experiments/exploration/scan_loop_area.h"
#include "planning/view/view_planner.h"
#include "slam/mapper.h"

namespace ariadne::experiments {

/// The view planner for a robot that errs: it keeps 5 cm from walls beside its half width, and places to
/// scan leave room to turn on the spot, which takes half its diagonal.
planning::ViewPlannerOptions RobotPlannerOptions();

/// A coarse but real scan: 181 beams in 128 slices (Sec. 2.2), which takes 1.7 s.
drivers::SimulatedRobotOptions CoarseRobotOptions();

/// Registration for scans that see each side of a thin wall by itself, from a guess that errs little: what
/// the surfaces hardly hold stays where odometry has it, in the alignments and in the graph.
slam::MapperOptions RobotMapperOptions();

struct Explore3dOptions {
  planning::ViewPlannerOptions planner = RobotPlannerOptions();
  ScanLoopAreaOptions area;
  drivers::SimulatedRobotOptions robot = CoarseRobotOptions();
  slam::MapperOptions mapper = RobotMapperOptions();
  FloorScannerOptions scanner;
  std::string heights = "1.5";
  double max_leg = 4.0;
  int max_scans = 60;
  int max_blocked = 6;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("planner", self.planner, "where to scan next");
    visit("area", self.area, "what is known to be free");
    visit("robot", self.robot, "the simulated robot and its scanner");
    visit("mapper", self.mapper, "how scans are registered; odometry is the first guess");
    visit("scanner", self.scanner, "what a scan can show of the cover, which counts as seen");
    visit("heights", self.heights,
          "of the slices [m]: a, b, ... Each is planned in by itself, and of their views that with the "
          "highest value is taken; the paper has one to five, 1.5 in its example (4.2)");
    visit("max_leg", self.max_leg, Unit("m"), Range{0.1, 1e6},
          "driven by odometry alone; a longer way is left off there for a scan towards its rest, and "
          "planned anew. After 8 m odometry errs by 20 to 30 cm: more than a door leaves room for, and "
          "more than registration mends where walls are parallel");
    visit("max_scans", self.max_scans, Unit(""), Range{1, 100000},
          "after which an exploration is given up");
    visit("max_blocked", self.max_blocked, Unit(""), Range{1, 100000},
          "ways in a row that ended at an obstacle, after which it is given up");
  }
};

/// A scan, and what came before it.
struct RobotScanStep {
  slam::Pose2 T_map_base_true;
  slam::Pose2 T_map_base;        // as estimated when it was registered
  slam::Pose2 T_map_base_guess;  // from which it was registered
  double path = 0.0;             // truly driven up to here [m]
  double covered = 0.0;          // share of the cover that was visible from the true places of the scanner
  double mapped = 0.0;           // share of the cover with a seen edge of the area within 10 cm
  int gain = 0;                  // rays, as planned
  bool registered = false;
  bool blocked = false;           // the way to where it was planned ended at an obstacle
  double planning_seconds = 0.0;  // unite and decide; times are not deterministic
  double matching_seconds = 0.0;
};

struct Exploration3d {
  std::vector<RobotScanStep> steps;
  bool ended = false;  // by itself: nothing was left that is worth a scan
  int collisions = 0;
  int refused = 0;  // scans whose registration was not trusted; they stay where odometry says
  std::vector<planning::LabelledPolygon> area;  // at the first height, at the end
  std::vector<slam::PosedCloud> scans;          // where they came to lie
  std::vector<slam::Pose3> T_map_laser_true;
  std::vector<Eigen::Vector2d> path_map_true;  // every 5 cm or so
};

/// A floor and what of it there is to see.
struct FloorToExplore {
  Floor floor;
  FloorCover cover;
};

/// Called after each scan.
using ExploreCallback = std::function<void(const RobotScanStep&)>;

/// The loop of Sec. 4 with a simulated robot: take a 3D scan, register it with the mapper, cut all scans at
/// each height and unite what they show to be free, plan, drive there by odometry, scan. The first scan
/// defines the map and lies where it truly is, so that the map's frame is the world's. Nothing else of the
/// truth reaches the robot; it only counts what was seen. The robot starts at the world's start.
///
/// A way that ends at an obstacle is not gone again: what stood there is cut out of the area, and the next
/// scan is taken where the robot has come to. A scan that the mapper does not trust counts with the pose of
/// its odometry. The same seed gives the same bytes, but for times.
Exploration3d Explore3d(std::shared_ptr<const drivers::RayScene> scene, const FloorToExplore& floor,
                        const Explore3dOptions& options, std::uint64_t seed,
                        const ExploreCallback& on_step = {});

/// How many scans, or how much way [m], it took to cover a share; infinite where it was not reached.
double ScansTo(const Exploration3d& exploration, double share);
double PathTo(const Exploration3d& exploration, double share);

}  // namespace ariadne::experiments
