#include <algorithm>
#include <cmath>

#include "slam/geometry/angles.h"
#include "slam/map/scan_mesh_surface.h"

namespace ariadne::slam {
namespace {

using Beam = ScanGrid::Beam;
constexpr std::size_t kNoBeam = ScanGrid::kNone;

/// Which way a row of beams runs: within a slice, or from slice to slice.
enum class Along { kSlice, kPitch };

double AngleBetween(const Beam& from, const Beam& to, Along along) {
  return along == Along::kSlice ? to.bearing - from.bearing : WrapAngle(to.pitch - from.pitch);
}

class JumpTest {
 public:
  JumpTest(const ScanGrid& grid, const ScanMeshOptions& options) : grid_(grid), jump_(options.jump) {}

  /// For two neighbours and what follows beyond each (or kNoBeam).
  bool IsContinuous(std::size_t beyond_a, std::size_t a, std::size_t b, std::size_t beyond_b,
                    Along along) const {
    if (a == kNoBeam || b == kNoBeam) return false;
    const Beam& beam_a = grid_.beams[a];
    const Beam& beam_b = grid_.beams[b];
    const double apart = (beam_a.direction_laser - beam_b.direction_laser).norm();
    const double allowed = std::max(jump_, apart * std::min(beam_a.range, beam_b.range));
    if (std::abs(beam_a.range - beam_b.range) <= allowed) return true;
    return Expects(beyond_a, a, b, along) && Expects(beyond_b, b, a, along);
  }

 private:
  /// Whether a plane through `outer` and `inner` is met by the beam `next` about where its range says.
  bool Expects(std::size_t outer, std::size_t inner, std::size_t next, Along along) const {
    if (outer == kNoBeam) return false;
    const Beam& o = grid_.beams[outer];
    const Beam& i = grid_.beams[inner];
    const Beam& n = grid_.beams[next];
    const double before = AngleBetween(o, i, along);
    if (before == 0.0) return false;
    const double slope = (1.0 / i.range - 1.0 / o.range) / before;
    const double inverse_range = 1.0 / i.range + slope * AngleBetween(i, n, along);
    return inverse_range > 0.0 && std::abs(1.0 / inverse_range - n.range) <= jump_;
  }

  const ScanGrid& grid_;
  double jump_;
};

std::size_t BeforeOf(const ScanGrid& grid, std::size_t i) {
  return i == kNoBeam ? kNoBeam : grid.beams[i].before;
}
std::size_t AfterOf(const ScanGrid& grid, std::size_t i) {
  return i == kNoBeam ? kNoBeam : grid.beams[i].after;
}
std::size_t LeftOf(const ScanGrid& grid, std::size_t i) {
  return i == kNoBeam ? kNoBeam : grid.beams[i].left;
}

}  // namespace

std::vector<Continuity> FindContinuity(const ScanGrid& grid, const ScanMeshOptions& options) {
  const JumpTest test(grid, options);
  std::vector<Continuity> continuity(grid.beams.size());
  for (std::size_t i = 0; i < grid.beams.size(); ++i) {
    const Beam& beam = grid.beams[i];
    continuity[i].left =
        test.IsContinuous(beam.right, i, beam.left, LeftOf(grid, beam.left), Along::kSlice);
    continuity[i].after =
        test.IsContinuous(beam.before, i, beam.after, AfterOf(grid, beam.after), Along::kPitch);
    continuity[i].before =
        test.IsContinuous(beam.after, i, beam.before, BeforeOf(grid, beam.before), Along::kPitch);
  }
  return continuity;
}

}  // namespace ariadne::slam
