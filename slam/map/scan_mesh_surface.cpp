#include "slam/map/scan_mesh_surface.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <optional>

#include "slam/geometry/angles.h"

namespace ariadne::slam {
namespace {

using Beam = ScanGrid::Beam;
constexpr std::size_t kNone = ScanGrid::kNone;

/// Which way a row of beams runs: within a slice, or from slice to slice.
enum class Along { kSlice, kPitch };

double AngleBetween(const Beam& from, const Beam& to, Along along) {
  return along == Along::kSlice ? to.bearing - from.bearing : WrapAngle(to.pitch - from.pitch);
}

class JumpTest {
 public:
  JumpTest(const ScanGrid& grid, const ScanMeshOptions& options) : grid_(grid), jump_(options.jump) {}

  /// For two neighbours and what follows beyond each (or kNone).
  bool IsContinuous(std::size_t beyond_a, std::size_t a, std::size_t b, std::size_t beyond_b,
                    Along along) const {
    if (a == kNone || b == kNone) return false;
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
    if (outer == kNone) return false;
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
  return i == kNone ? kNone : grid.beams[i].before;
}
std::size_t AfterOf(const ScanGrid& grid, std::size_t i) {
  return i == kNone ? kNone : grid.beams[i].after;
}
std::size_t LeftOf(const ScanGrid& grid, std::size_t i) { return i == kNone ? kNone : grid.beams[i].left; }

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
      if (at == kNone || !continuity_[at].left) break;
      members_.push_back(at);
    }
  }

  const ScanGrid& grid_;
  const std::vector<Continuity>& continuity_;
  int beams_;
  std::vector<std::size_t> members_;
};

/// A plane is met by a beam at 1 / range = m . direction: a linear fit in the coordinates of a tangent
/// plane to the unit sphere at the beam.
class PlaneThroughBeams {
 public:
  explicit PlaneThroughBeams(double range_sigma) : tolerance_(2.5 * range_sigma) {}

  BeamSurface Fit(const ScanGrid& grid, std::size_t center, const std::vector<std::size_t>& window) {
    constexpr std::size_t kFewest = 6;
    const Beam& beam = grid.beams[center];
    BeamSurface surface{beam.range, Eigen::Vector3d::Zero()};
    if (window.size() < kFewest) return surface;
    const Eigen::Vector3d& d = beam.direction_laser;
    const Eigen::Vector3d e1 = d.unitOrthogonal();
    const Eigen::Vector3d e2 = d.cross(e1);
    samples_.clear();
    for (const std::size_t i : window) {
      const Beam& other = grid.beams[i];
      const double cosine = other.direction_laser.dot(d);
      samples_.push_back(
          {{1.0, other.direction_laser.dot(e1) / cosine, other.direction_laser.dot(e2) / cosine},
           1.0 / (other.range * cosine),
           other.range * other.range});
    }
    const std::optional<Eigen::Vector3d> plane = FitRobustly();
    if (!plane || !((*plane)[0] > 0.0)) return surface;
    const double moved = 1.0 / (*plane)[0] - beam.range;
    if (std::abs(moved) > 2.0 * tolerance_)
      return surface;  // the beam is on none of its neighbours' planes
    surface.range = beam.range + moved;
    surface.normal_laser = -((*plane)[0] * d + (*plane)[1] * e1 + (*plane)[2] * e2).normalized();
    return surface;
  }

 private:
  struct Sample {
    Eigen::Vector3d x;  // 1 and the place in the tangent plane
    double value;       // 1 / range along the middle beam [1/m]
    double scale;       // from an error of the value to one of the range [m^2]
  };

  double Weight(const Eigen::Vector3d& plane, const Sample& sample) const {
    const double off = (sample.value - plane.dot(sample.x)) * sample.scale / tolerance_;
    return 1.0 / ((1.0 + off * off) * (1.0 + off * off));
  }

  double Agreement(const Eigen::Vector3d& plane) const {
    double sum = 0.0;
    for (const Sample& sample : samples_) sum += Weight(plane, sample);
    return sum;
  }

  /// Of a weighted linear fit.
  struct NormalEquations {
    Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
    Eigen::Vector3d b = Eigen::Vector3d::Zero();

    void Add(const Sample& sample, double weight) {
      A += weight * sample.x * sample.x.transpose();
      b += weight * sample.value * sample.x;
    }
    void Add(const NormalEquations& other) {
      A += other.A;
      b += other.b;
    }
    std::optional<Eigen::Vector3d> Solve() const {
      const Eigen::LDLT<Eigen::Matrix3d> factor(A);
      const Eigen::Vector3d pivots = factor.vectorD();
      if (!(pivots.minCoeff() > 1e-12 * pivots.maxCoeff())) return std::nullopt;  // all in one row
      return Eigen::Vector3d(factor.solve(b));
    }
  };

  /// The eighth of the window in which a sample lies, anticlockwise.
  static std::size_t EighthOf(const Sample& sample) {
    constexpr std::array<std::size_t, 8> kAnticlockwise{0, 1, 3, 2, 7, 6, 4, 5};
    const double x = sample.x[1], y = sample.x[2];
    return kAnticlockwise[(y < 0.0 ? 4U : 0U) | (x < 0.0 ? 2U : 0U) |
                          (std::abs(y) > std::abs(x) ? 1U : 0U)];
  }

  /// At an edge the plane through all is on neither side: then the planes through half of the window
  /// compete for the agreement of the whole.
  Eigen::Vector3d BestOfHalves(const Eigen::Vector3d& plane_of_all) const {
    std::array<NormalEquations, 8> eighths;
    for (const Sample& sample : samples_) eighths[EighthOf(sample)].Add(sample, 1.0);
    Eigen::Vector3d best = plane_of_all;
    double most = Agreement(best);
    for (std::size_t first = 0; first < 8; ++first) {
      NormalEquations half = eighths[first];
      for (std::size_t k = 1; k < 4; ++k) half.Add(eighths[(first + k) % 8]);
      const std::optional<Eigen::Vector3d> plane = half.Solve();
      const double agreement = plane ? Agreement(*plane) : 0.0;
      if (agreement <= most) continue;
      best = *plane;
      most = agreement;
    }
    return best;
  }

  std::optional<Eigen::Vector3d> FitRobustly() const {
    constexpr double kFlat = 0.8;  // mean weight of noise alone
    constexpr int kIterations = 3;
    NormalEquations all;
    for (const Sample& sample : samples_) all.Add(sample, 1.0);
    std::optional<Eigen::Vector3d> plane = all.Solve();
    if (!plane) return plane;
    if (Agreement(*plane) < kFlat * static_cast<double>(samples_.size())) plane = BestOfHalves(*plane);
    for (int i = 0; i < kIterations && plane; ++i) {
      NormalEquations agreeing;
      for (const Sample& sample : samples_) agreeing.Add(sample, Weight(*plane, sample));
      plane = agreeing.Solve();
    }
    return plane;
  }

  double tolerance_;  // at which a neighbour counts a quarter [m]
  std::vector<Sample> samples_;
};

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
