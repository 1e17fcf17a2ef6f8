#include "slam/map/scan_layers.h"

#include <array>
#include <string>
#include <utility>

#include "slam/map/layer_names.h"

namespace ariadne::slam {
namespace {

// Okabe and Ito's, without black, which lines have, and yellow, which white paper swallows.
constexpr std::array<Rgb, 6> kScanColors{
    {{0, 114, 178}, {213, 94, 0}, {0, 158, 115}, {204, 121, 167}, {86, 180, 233}, {230, 159, 0}}};

}  // namespace

Rgb ScanColor(std::size_t scan) { return kScanColors[scan % kScanColors.size()]; }

std::vector<DrawingLayer> ScanLayers(std::span<const PosedCloud> scans) {
  std::vector<std::string> names;
  for (const PosedCloud& scan : scans) names.push_back(scan.name);
  const std::vector<std::string> layer_names = LayerNames("scan_", names);
  std::vector<DrawingLayer> layers;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    if (scans[i].cloud_laser.empty()) continue;
    PointCloud cloud_map = Transformed(scans[i].T_map_laser, scans[i].cloud_laser);
    layers.push_back({layer_names[i], ScanColor(i), std::move(cloud_map.positions), {}, {}});
  }
  return layers;
}

}  // namespace ariadne::slam
