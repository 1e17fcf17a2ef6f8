#pragma once

#include <Eigen/Core>
#include <span>

#include "control/differential_drive.h"
#include "slam/base/options.h"

namespace ariadne::drivers {

/// A square that a robot has driven by its odometry alone, back to where it began: where it truly came to,
/// less where the odometry took it to be, in the frame in which it started along x.
struct DrivenSquare {
  bool counterclockwise = true;
  Eigen::Vector2d error = Eigen::Vector2d::Zero();  // [m]
};

struct UmbmarkOptions {
  double side = 4.0;
  double measurement_sigma = 0.002;
  double max_ratio_error = 0.05;
  double max_track_error = 0.1;
  double max_sigma = 0.005;
  double max_chi2 = 20.0;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("side", self.side, Unit("m"), Range{0.2, 100.0}, "of the square, 4 m in UMBmark");
    visit("measurement_sigma", self.measurement_sigma, Unit("m"), Range{1e-5, 1.0},
          "of the tape with which the errors are measured");
    visit("max_ratio_error", self.max_ratio_error, Unit(""), Range{0.0, 0.25},
          "of the ratio of the wheels' radii; more is another wheel or a flat tyre");
    visit("max_track_error", self.max_track_error, Unit(""), Range{0.0, 0.5},
          "of the track, relative; more is a wrong drawing");
    visit(
        "max_sigma", self.max_sigma, Unit(""), Range{1e-6, 1.0},
        "of either, relative; where squares of one direction differ more from each other, the floor is too "
        "slippery");
    visit(
        "max_chi2", self.max_chi2, Unit(""), Range{1.0, 1e9},
        "by which unequal wheels and a wrong track fail to explain both directions (2 degrees of freedom)");
  }
};

struct WheelCalibration {
  control::DriveGeometry geometry;  // with the corrected ratio and track
  double ratio_factor = 1.0;        // right to left radius, of what was taken for it: UMBmark's E_d
  double track_factor = 1.0;        // true track, of what was taken for it: UMBmark's E_b
  Eigen::Matrix2d covariance;       // of the factors
  double error_before = 0.0;        // the larger of the mean errors: UMBmark's E_max,syst [m]
  double error_after = 0.0;         // what is left of it [m]
  double scatter = 0.0;             // of one square about its mean [m]
  double chi2 = 0.0;
};

/// How much the ratio of the wheels' radii and the track differ from what the odometry of the squares had
/// taken them for: UMBmark (Borenstein and Feng, Measurement and correction of systematic odometry errors
/// in mobile robots, IEEE Trans. Robotics and Automation 12 (1996) 869-880), with its two errors estimated
/// from both coordinates by least squares on exact arcs, instead of from their first-order formulas. The
/// mean radius, which the size of the square would tell, is not touched. The covariance comes from how the
/// squares of each direction differ. At least three squares each way; UMBmark drives five.
///
/// Error where there are too few, where they differ too much, where the two errors cannot explain them, and
/// where the result is no plausible wheel.
WheelCalibration CalibrateWheels(std::span<const DrivenSquare> squares,
                                 const control::DriveGeometry& driven, const UmbmarkOptions& options = {});

/// Where a square of this side ends whose wheels err by the factors, while its odometry says: at the start.
Eigen::Vector2d SquareError(bool counterclockwise, double ratio_factor, double track_factor, double side,
                            double track);

}  // namespace ariadne::drivers
