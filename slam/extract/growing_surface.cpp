#include "slam/extract/growing_surface.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace ariadne::slam {
namespace {

using Link = GrowingSurface::Link;

/// The ring between the parts of two lines that face each other.
std::vector<Eigen::Vector3d> Bridge(const GrowingSurface::Strand& strand, const SpatialLine& line) {
  return {NearestOnSegment(strand.from(), strand.to(), line.from_laser),
          NearestOnSegment(strand.from(), strand.to(), line.to_laser),
          NearestOnSegment(line.from_laser, line.to_laser, strand.to()),
          NearestOnSegment(line.from_laser, line.to_laser, strand.from())};
}

/// Up the right ends, down the left ends.
std::vector<Eigen::Vector3d> RingOf(const GrowingSurface::Strand& strand) {
  std::vector<Eigen::Vector3d> ring = strand.right;
  ring.insert(ring.end(), strand.left.rbegin(), strand.left.rend());
  return ring;
}

Ring InPlane(const PlanarSurface& surface, const std::vector<Eigen::Vector3d>& ring_laser) {
  Ring ring;
  ring.reserve(ring_laser.size());
  for (const Eigen::Vector3d& p : ring_laser) ring.push_back(InPlane(surface, p));
  return ring;
}

}  // namespace

Eigen::Vector3d NearestOnSegment(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                 const Eigen::Vector3d& p) {
  const Eigen::Vector3d ab = b - a;
  const double squared = ab.squaredNorm();
  if (squared == 0.0) return a;
  return a + std::clamp(ab.dot(p - a) / squared, 0.0, 1.0) * ab;
}

GrowingSurface::GrowingSurface(const SpatialLine& line, std::size_t slice)
    : strands_{{{line.from_laser}, {line.to_laser}, slice, true}}, moments_(line.from_laser) {
  Explain(line);
}

bool GrowingSurface::HasPlane() const {
  constexpr double kFlat = 6.0;  // variance in the plane by that across it, well above that of noise alone
  return lines_ > 1 && variances_[1] > kFlat * variances_[0];
}

double GrowingSurface::Deviation(const SpatialLine& line, const SliceNoise& noise) const {
  if (!HasPlane()) return 0.0;
  const Eigen::Vector3d normal = axes_.col(0);
  const auto count = static_cast<double>(moments_.count());
  double worst = 0.0;
  for (const Eigen::Vector3d& end : {line.from_laser, line.to_laser}) {
    const Eigen::Vector3d d = axes_.transpose() * (end - mean_);
    const double lever = d[1] * d[1] / variances_[1] + d[2] * d[2] / variances_[2];
    const double shared = SystematicAcross(normal, end, end.norm() - mean_.norm(), noise);
    // The plane is as uncertain as the points it came from, and more so away from them; and ranges that
    // are far from theirs are wrong by something else.
    const double sigma =
        std::hypot(SigmaAcross(normal, end, noise) * std::sqrt(1.0 + (1.0 + lever) / count), shared);
    worst = std::max(worst, std::abs(d[0]) / sigma);
  }
  return worst;
}

void GrowingSurface::Explain(const SpatialLine& line) {
  for (const Eigen::Vector3d& p : line.explained_laser) moments_.Add(p);
  explained_laser_.insert(explained_laser_.end(), line.explained_laser.begin(), line.explained_laser.end());
  ++lines_;
  UpdatePlane();
}

void GrowingSurface::UpdatePlane() {
  constexpr double kLeastVariance = 1e-12;  // of points in one place [m^2]
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(moments_.Covariance());
  mean_ = moments_.Mean();
  axes_ = solver.eigenvectors();
  variances_ = solver.eigenvalues().cwiseMax(kLeastVariance);
}

void GrowingSurface::Continue(const std::vector<Link>& links, std::size_t slice) {
  const auto shares = [&](const Link& link) {
    return std::ranges::any_of(links, [&](const Link& other) {
      return (other.strand == link.strand) != (other.line == link.line);
    });
  };
  std::vector<const SpatialLine*> begun;
  for (const Link& link : links) {
    Strand& strand = strands_[link.strand];
    if (!shares(link)) {
      strand.right.push_back(link.line->from_laser);
      strand.left.push_back(link.line->to_laser);
      strand.slice = slice;
      continue;
    }
    strand.goes_on = false;
    bridges_.push_back(Bridge(strand, *link.line));
    if (std::ranges::find(begun, link.line) == begun.end()) begun.push_back(link.line);
  }
  for (const SpatialLine* line : begun) {
    strands_.push_back({{line->from_laser}, {line->to_laser}, slice, true});
  }
}

std::optional<PlanarSurface> GrowingSurface::Fit(const SliceNoise& noise) const {
  std::optional<PlanarSurface> surface = FitSurface(explained_laser_, noise);
  if (!surface) return std::nullopt;
  std::vector<Ring> rings;
  for (const Strand& strand : strands_) rings.push_back(InPlane(*surface, RingOf(strand)));
  for (const auto& bridge : bridges_) rings.push_back(InPlane(*surface, bridge));
  surface->outlines = United(rings);
  return surface;
}

}  // namespace ariadne::slam
