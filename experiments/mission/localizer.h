#pragma once

#include <vector>

#include "drivers/robot.h"
#include "slam/matching/map_scan.h"
#include "slam/registration/locate_sweep.h"

namespace ariadne::experiments {

struct LocalizerOptions {
  bool enabled = true;
  double every_distance = 0.15;
  double every_angle = 0.15;
  double position = 0.05;
  double angle_by_way = 0.02;
  double angle_by_turn = 0.03;
  double reach = 20.0;
  slam::LocateOptions locate;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit(
        "enabled", self.enabled,
        "look around with the scanner in horizontal mode while driving (5.3) and correct the odometry; the "
        "paper's robot drives by odometry alone");
    visit("every_distance", self.every_distance, Unit("m"), Range{0.01, 100.0}, "driven, a sweep");
    visit("every_angle", self.every_angle, Unit("rad"), Range{0.01, 10.0}, "turned, a sweep");
    visit("position", self.position, Unit("m per sqrt(m)"), Range{1e-6, 10.0},
          "sigma of the odometry's position after 1 m; its variance grows with the way");
    visit("angle_by_way", self.angle_by_way, Unit("rad, after 1 m"), Range{1e-6, 10.0},
          "sigma of the odometry's angle after 1 m");
    visit("angle_by_turn", self.angle_by_turn, Unit("rad, after 1 rad"), Range{1e-6, 10.0},
          "and after a turn of 1 rad");
    visit("reach", self.reach, Unit("m"), Range{1.0, 1000.0},
          "scans that were taken farther away do not count");
    visit("locate", self.locate, "how a sweep is laid on the map");
  }
};

/// Where a driving robot is in the map: odometry, and from time to time a horizontal sweep against what
/// scans have shown. Without a map it is odometry alone.
class Localizer {
 public:
  /// `model_map` may be empty, `scanner` is the 3D scanner's. The robot is at T_map_base now.
  Localizer(drivers::Robot& robot, const slam::Pose2& T_map_base, const slam::AlignModel* model_map,
            const slam::ScannerModel& scanner, const LocalizerOptions& options);

  /// Reads the odometry, and takes a sweep where one is due.
  const slam::Pose2& Update();

  const slam::Pose2& T_map_base() const { return T_map_base_; }
  /// In the tangent space of the pose: what sweeps and odometry leave open, and what the sweeps share, the
  /// errors of the map's own scans.
  slam::Pose2::Square covariance() const;
  const slam::ScannerModel& scanner() const { return scanner_; }
  int corrections() const { return corrections_; }

 private:
  void Predict();
  void Correct();

  drivers::Robot& robot_;
  const slam::AlignModel* model_map_;
  slam::ScannerModel scanner_;
  LocalizerOptions options_;
  slam::Pose2 T_map_base_;
  slam::Pose2::Square covariance_;
  drivers::RobotState last_;
  double way_ = 0.0, turn_ = 0.0;  // since the last sweep
  int corrections_ = 0;
};

}  // namespace ariadne::experiments
