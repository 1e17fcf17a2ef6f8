#pragma once

#include <array>
#include <filesystem>
#include <string_view>

#include "control/odometry.h"
#include "drivers/hardware/dynamixel/servo.h"
#include "slam/base/options.h"

namespace ariadne::experiments {

/// What is taken out of a log of lines.
enum class LineLogFormat {
  kTelegrams,  // text, a line per telegram: time, line, direction, what it says
  kSweeps,     // CSV, a row per sweep: time, pitch, first angle, step, ranges
  kXyz,        // the sweeps' points in the frame of the laser, turned by the servo's pitch
  kOdometry,   // CSV, a row per reading of the encoders: time, left and right counts
  kTum         // the odometry that follows from them: stamp, translation, quaternion
};

struct LineLogExportOptions {
  drivers::dynamixel::ServoOptions servo;
  control::DriveGeometry wheels;
  double turn_period = 1.0 / 75.0;
  bool swap_motors = false;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("servo", self.servo, "where its zero is, and which way it turns: the pitch of sweeps");
    visit("wheels", self.wheels, "of tum");
    visit("turn_period", self.turn_period, Unit("s"), Range{0.005, 0.1},
          "of the scanner's mirror; 75 turns/s (9.3)");
    visit("swap_motors", self.swap_motors, "whether motor 1 of the board is the right wheel");
  }
};

/// How much there was.
struct LineLogExport {
  std::size_t rows = 0;  // telegrams, sweeps, points or readings
};

/// Writes what a log holds in a format. Sweeps are in the middle of their turns by when their telegrams
/// arrived, which is up to some milliseconds late; the scans of a run are stamped better by its driver.
/// Error where the log has nothing of the kind.
LineLogExport ExportLineLog(const std::filesystem::path& name, LineLogFormat format,
                            const LineLogExportOptions& options, const std::filesystem::path& out);

}  // namespace ariadne::experiments

template <>
struct ariadne::EnumNames<ariadne::experiments::LineLogFormat> {
  static constexpr std::array<std::string_view, 5> value = {"telegrams", "sweeps", "xyz", "odometry",
                                                            "tum"};
};
