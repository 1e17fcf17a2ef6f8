#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "drivers/calibration/scanner_mounting.h"
#include "slam/extract/classify_surfaces.h"
#include "slam/extract/extract_surfaces.h"

namespace ariadne::drivers {

struct CalibrationPlanesOptions {
  slam::ExtractSurfacesOptions extract;
  slam::ClassifyOptions classify;
  double gate = 0.06;
  double min_range = 0.3;
  int min_points = 300;
  bool ceilings = true;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("extract", self.extract, "how surfaces are found");
    visit("classify", self.classify, "which of them are floor, walls and ceiling");
    visit("gate", self.gate, Unit("m"), Range{0.005, 1.0}, "from a surface, for its points");
    visit("min_range", self.min_range, Unit("m"), Range{0.0, 10.0}, "nearer ones see the robot itself");
    visit("min_points", self.min_points, Unit(""), Range{10, 1e7}, "of a surface that counts");
    visit("ceilings", self.ceilings, "whether ceilings are as level as the floor");
  }
};

/// What of a building is known before it is measured: floors are level and at height 0, ceilings level,
/// walls upright.
enum class PlaneKind { kFloor, kCeiling, kWall };

/// The beams that end on one surface of one scan.
struct CalibrationPlane {
  PlaneKind kind = PlaneKind::kFloor;
  double bearing = 0.0;  // of a wall's normal [rad], a first guess
  double offset = 0.0;   // of a wall or ceiling along its normal [m], a first guess
  std::vector<MeasuredBeam> beams;
  std::vector<std::size_t> slices;  // of each beam: beams of a slice share errors
};

/// Finds the surfaces of scans that were taken standing. Slices are numbered over all scans.
std::vector<CalibrationPlane> FindCalibrationPlanes(std::span<const slam::Scan> scans,
                                                    const ScannerMounting& guess,
                                                    const CalibrationPlanesOptions& options);

}  // namespace ariadne::drivers
