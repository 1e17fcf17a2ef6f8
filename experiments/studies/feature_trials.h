#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "drivers/simulated/ais_scanner_options.h"
#include "experiments/metrics/line_detection.h"
#include "experiments/metrics/surface_detection.h"
#include "slam/extract/extract_surfaces.h"

namespace ariadne::experiments {

/// A detector of lines under its name in tables.
struct LineDetector {
  std::string name;
  slam::LineOptions options;
};

/// The paper's, Hough in its two forms, and split-and-merge, with the options given for each.
std::vector<LineDetector> LineDetectors(const slam::LineOptions& options);

/// The outcome of a detector over many slices or scans.
struct LineTrial {
  LineScore score;
  std::vector<double> seconds;  // of each slice
};
struct SurfaceTrial {
  SurfaceScore score;
  std::vector<double> seconds;  // of each scan
};

/// Called before each room, with its number.
using OnRoom = std::function<void(int room)>;

/// Each detector on the same level slices of random rooms, with all errors of the scanner.
std::vector<LineTrial> TryLines(const std::vector<LineDetector>& detectors, int rooms, int seed,
                                const drivers::AisScannerOptions& scanner, const OnRoom& on_room);

/// Both methods on the same scans of random rooms.
std::vector<SurfaceTrial> TrySurfaces(const slam::ExtractSurfacesOptions& options, int rooms, int seed,
                                      const drivers::AisScannerOptions& scanner, const OnRoom& on_room);

/// A detector on real sweeps, which have no truth: what it explains, and whether the next sweep, taken a
/// moment later, shows the same lines where odometry says that they are.
struct LogTrial {
  std::size_t sweeps = 0;
  std::size_t lines = 0;        // longer than 0.5 m
  std::size_t points = 0;       // of the sweeps
  std::size_t explained = 0;    // of these: on lines of any length
  std::size_t repeatable = 0;   // of the lines: whose middle the next sweep can see
  std::size_t repeated = 0;     // of these: found again, to 5 deg and 5 cm
  std::vector<double> angles;   // between a line and itself in the next sweep [rad]
  std::vector<double> offsets;  // [m]
  std::vector<double> rms;      // of the points [m]
  std::vector<double> seconds;  // of each sweep
};

/// Each detector on pairs of successive sweeps of a CARMEN log, one pair in `every` sweeps.
std::vector<LogTrial> TryLog(const std::vector<LineDetector>& detectors, const std::filesystem::path& log,
                             int every);

}  // namespace ariadne::experiments
