#pragma once

#include <span>
#include <vector>

#include "slam/geometry/drawing.h"
#include "slam/scan/point_cloud.h"

namespace ariadne::slam {

/// A colour per scan, in turn, which the colour blind can tell from each other.
Rgb ScanColor(std::size_t scan);

/// The points of each scan that has some, in the map frame, in a layer of its own: "scan_" and its name.
std::vector<DrawingLayer> ScanLayers(std::span<const PosedCloud> scans);

}  // namespace ariadne::slam
