#pragma once

#include <filesystem>
#include <span>

#include "slam/base/options.h"
#include "slam/scan/point_cloud.h"

namespace ariadne::slam {

struct OctoMapOptions {
  double resolution = 0.05;
  double max_range = 0.0;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("resolution", self.resolution, Unit("m"), Range{0.001, 10.0},
          "edge of the smallest cell; a map reaches 32768 of them from the origin to all sides");
    visit("max_range", self.max_range, Unit("m"), Range{0.0, 1000.0},
          "of a beam: a longer one shows free space up to here, and nothing at its end; 0: none is too "
          "long");
  }
};

/// Writes what the scans saw as an OctoMap, in the map frame: cells with points are occupied, cells that
/// beams from the laser to its points went through are free, each by the votes of the scans (a scan has one
/// vote per cell, and points outvote beams; OctoMap's own probabilities). The extension says what is kept:
/// .bt free and occupied, .ot the probabilities. Beams are cast once per cell with points. Error for
/// another extension, without points, for a place that is not finite or out of OctoMap's reach, or where
/// the file cannot be written.
void WriteOctoMap(const std::filesystem::path& path, std::span<const PosedCloud> scans,
                  const OctoMapOptions& options = {});

}  // namespace ariadne::slam
