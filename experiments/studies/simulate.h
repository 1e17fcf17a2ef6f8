#pragma once

#include <array>

#include "experiments/run/progress_display.h"
#include "experiments/run/run_directory.h"
#include "experiments/run/scan_source.h"

namespace ariadne::experiments {

enum class ScanFileFormat { kUos, kPly, kPcd };

/// The experiment `simulate`: a data set with its truth, for this program and for others.
struct SimulateOptions {
  InputOptions input = InputOptions::OfTour();
  ScanFileFormat format = ScanFileFormat::kUos;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("input", self.input, "which scans");
    visit("format", self.format,
          "of the files: .3d with .pose files for 3DTK, .ply or .pcd with poses.txt");
  }
};

/// Writes scans/ (a file per scan, their poses by odometry, truth.tum), odometry.tum and truth.tum; returns
/// what to print.
std::string RunSimulate(const SimulateOptions& options, const RunDirectory& run, ProgressDisplay& progress);

}  // namespace ariadne::experiments

namespace ariadne {

template <>
struct EnumNames<experiments::ScanFileFormat> {
  static constexpr std::array<std::string_view, 3> value{"uos", "ply", "pcd"};
};

}  // namespace ariadne
