#pragma once

#include "drivers/calibration/calibration_planes.h"

namespace ariadne::drivers {

struct CalibrateScannerOptions {
  CalibrationPlanesOptions planes;
  double range_offset_sigma = 0.015;
  double max_sigma_angle = 0.003;
  double max_sigma_length = 0.01;
  double max_angle = 0.12;
  double max_height_error = 0.15;
  double max_mirror_offset = 0.15;
  double max_rms = 0.03;
  int max_iterations = 50;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("planes", self.planes, "what is taken from the scans");
    visit("range_offset_sigma", self.range_offset_sigma, Unit("m"), Range{1e-4, 1.0},
          "of ranges that are all too long or too short, as the data sheet has it");
    visit("max_sigma_angle", self.max_sigma_angle, Unit("rad"), Range{1e-5, 1.0},
          "roll and pitch that are less certain are not told");
    visit("max_sigma_length", self.max_sigma_length, Unit("m"), Range{1e-5, 1.0},
          "height and mirror offset that are less certain are not told");
    visit("max_angle", self.max_angle, Unit("rad"), Range{0.0, 1.0},
          "of roll and pitch from the guess; more is no mounting error, but another mounting");
    visit("max_height_error", self.max_height_error, Unit("m"), Range{0.0, 10.0}, "from the guess");
    visit("max_mirror_offset", self.max_mirror_offset, Unit("m"), Range{0.0, 1.0},
          "of the mirror's centre");
    visit("max_rms", self.max_rms, Unit("m"), Range{0.001, 1.0},
          "of the points from their surfaces; more is something that moved, or a servo that skips");
    visit("max_iterations", self.max_iterations, Unit(""), Range{1, 1000}, "of Gauss-Newton");
  }
};

struct ScannerCalibration {
  ScannerMounting mounting;
  Eigen::Matrix<double, ScannerMounting::kSize, ScannerMounting::kSize> covariance;  // as ToVector
  double rms = 0.0;  // of the points from their surfaces, robust [m]
  int iterations = 0;
  bool settled = false;
  std::size_t floors = 0, walls = 0, ceilings = 0;
  std::size_t points = 0;
};

/// The mounting with which floors become level and of height 0, ceilings level, and walls upright and flat
/// at all pitches: Gauss-Newton on the distances of points from their surfaces, with Tukey's weights.
/// The covariance takes all points of a slice for one observation with a common error, because the pitch
/// of a slice errs as a whole; it says nothing of a floor that is not flat.
///
/// Error where there is no floor or too little to see, where what is asked for cannot be told from the
/// scans, or where the result is no plausible mounting.
ScannerCalibration CalibrateScanner(std::span<const slam::Scan> scans, const ScannerMounting& guess,
                                    const CalibrateScannerOptions& options = {});

/// The second half of it, from surfaces that are known.
ScannerCalibration CalibrateOnPlanes(std::span<const CalibrationPlane> planes, const ScannerMounting& guess,
                                     const CalibrateScannerOptions& options = {});

}  // namespace ariadne::drivers
