#include "slam/map/plane_through_beams.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <array>
#include <cmath>

namespace ariadne::slam {

double PlaneThroughBeams::Weight(const Eigen::Vector3d& plane, const Sample& sample) const {
  const double off = (sample.value - plane.dot(sample.x)) * sample.scale / tolerance_;
  return 1.0 / ((1.0 + off * off) * (1.0 + off * off));
}

double PlaneThroughBeams::Agreement(const Eigen::Vector3d& plane) const {
  double sum = 0.0;
  for (const Sample& sample : samples_) sum += Weight(plane, sample);
  return sum;
}

/// Of a weighted linear fit.
struct PlaneThroughBeams::NormalEquations {
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
std::size_t PlaneThroughBeams::EighthOf(const Sample& sample) {
  constexpr std::array<std::size_t, 8> kAnticlockwise{0, 1, 3, 2, 7, 6, 4, 5};
  const double x = sample.x[1], y = sample.x[2];
  return kAnticlockwise[(y < 0.0 ? 4U : 0U) | (x < 0.0 ? 2U : 0U) | (std::abs(y) > std::abs(x) ? 1U : 0U)];
}

/// At an edge the plane through all is on neither side: then the planes through half of the window
/// compete for the agreement of the whole.
Eigen::Vector3d PlaneThroughBeams::BestOfHalves(const Eigen::Vector3d& plane_of_all) const {
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

std::optional<Eigen::Vector3d> PlaneThroughBeams::FitRobustly() const {
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

BeamSurface PlaneThroughBeams::Fit(const ScanGrid& grid, std::size_t center,
                                   const std::vector<std::size_t>& window) {
  constexpr std::size_t kFewest = 6;
  const ScanGrid::Beam& beam = grid.beams[center];
  BeamSurface surface{beam.range, Eigen::Vector3d::Zero()};
  if (window.size() < kFewest) return surface;
  const Eigen::Vector3d& d = beam.direction_laser;
  const Eigen::Vector3d e1 = d.unitOrthogonal();
  const Eigen::Vector3d e2 = d.cross(e1);
  samples_.clear();
  for (const std::size_t i : window) {
    const ScanGrid::Beam& other = grid.beams[i];
    const double cosine = other.direction_laser.dot(d);
    samples_.push_back(
        {{1.0, other.direction_laser.dot(e1) / cosine, other.direction_laser.dot(e2) / cosine},
         1.0 / (other.range * cosine),
         other.range * other.range});
  }
  const std::optional<Eigen::Vector3d> plane = FitRobustly();
  if (!plane || !((*plane)[0] > 0.0)) return surface;
  const double moved = 1.0 / (*plane)[0] - beam.range;
  if (std::abs(moved) > 2.0 * tolerance_) return surface;  // the beam is on none of its neighbours' planes
  surface.range = beam.range + moved;
  surface.normal_laser = -((*plane)[0] * d + (*plane)[1] * e1 + (*plane)[2] * e2).normalized();
  return surface;
}

}  // namespace ariadne::slam
