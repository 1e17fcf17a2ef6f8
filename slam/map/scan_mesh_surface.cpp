#include "slam/map/scan_mesh_surface.h"

#include <algorithm>
#include <cmath>

#include "slam/map/plane_through_beams.h"

namespace ariadne::slam {
namespace {

/// Beams around one, over continuous links.
class Window {
 public:
  Window(const ScanGrid& grid, const std::vector<Continuity>& continuity, int beams)
      : grid_(grid), continuity_(continuity), beams_(beams) {}

  const std::vector<std::size_t>& Around(std::size_t center) {
    members_.clear();
    AddRow(center);
    // As many slices as span the angle of the beams; near the tilt axis slices lie close together.
    const double slice_step = grid_.pitch_step * std::sin(grid_.beams[center].bearing);
    constexpr double kMostSlices = 12.0;
    const double wanted =
        std::clamp(beams_ * grid_.bearing_step / std::max(slice_step, 1e-9), 1.0, kMostSlices);
    const auto slices = static_cast<int>(std::lround(wanted));
    std::size_t at = center;
    for (int s = 0; s < slices && continuity_[at].after; ++s) AddRow(at = grid_.beams[at].after);
    at = center;
    for (int s = 0; s < slices && continuity_[at].before; ++s) AddRow(at = grid_.beams[at].before);
    return members_;
  }

 private:
  void AddRow(std::size_t middle) {
    members_.push_back(middle);
    std::size_t at = middle;
    for (int k = 0; k < beams_ && continuity_[at].left; ++k) members_.push_back(at = grid_.beams[at].left);
    at = middle;
    for (int k = 0; k < beams_; ++k) {
      at = grid_.beams[at].right;
      if (at == ScanGrid::kNone || !continuity_[at].left) break;
      members_.push_back(at);
    }
  }

  const ScanGrid& grid_;
  const std::vector<Continuity>& continuity_;
  int beams_;
  std::vector<std::size_t> members_;
};

}  // namespace

std::vector<BeamSurface> FitSurfaces(const ScanGrid& grid, const std::vector<Continuity>& continuity,
                                     const ScanMeshOptions& options) {
  Window window(grid, continuity, options.smooth_beams);
  PlaneThroughBeams plane(options.range_sigma);
  std::vector<BeamSurface> surfaces;
  surfaces.reserve(grid.beams.size());
  for (std::size_t i = 0; i < grid.beams.size(); ++i) {
    surfaces.push_back(plane.Fit(grid, i, window.Around(i)));
  }
  return surfaces;
}

}  // namespace ariadne::slam
