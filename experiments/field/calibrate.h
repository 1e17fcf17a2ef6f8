#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "drivers/calibration/calibrate_scanner.h"
#include "drivers/calibration/umbmark.h"
#include "drivers/hardware/robot/hardware_robot_options.h"

namespace ariadne::experiments {

struct CalibrateScannerRunOptions {
  drivers::LaserMountOptions mount;
  int scans = 5;
  drivers::CalibrateScannerOptions scanner;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("mount", self.mount, "of the scanner as it should be: the first guess");
    visit("scans", self.scans, Unit(""), Range{1, 1000}, "of each run, the first ones");
    visit("scanner", self.scanner, "the calibration");
  }
};

struct CalibrateWheelsFileOptions {
  control::DriveGeometry drive;
  drivers::UmbmarkOptions squares;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("drive", self.drive, "the wheels as the odometry of the squares took them to be");
    visit("squares", self.squares, "the squares");
  }
};

/// The first scans on the log of a run, as its robot took them. Error where it has none.
std::vector<slam::Scan> ReadLoggedScans(const std::filesystem::path& run, int count);

/// Squares as text: a line each, "ccw" or "cw" and the error in x and y [m], separated by blanks or commas;
/// # begins a comment. Error with file and line.
std::vector<drivers::DrivenSquare> ReadSquares(std::istream& in, const std::string& name);

// What was found, for people, and the lines for the configuration of the robot.
std::string CalibrateScannerText(const std::vector<std::string>& runs,
                                 const CalibrateScannerRunOptions& options);
std::string CalibrateWheelsText(const std::string& file, const CalibrateWheelsFileOptions& options);

}  // namespace ariadne::experiments
