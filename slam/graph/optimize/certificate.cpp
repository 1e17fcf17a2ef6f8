#include "slam/graph/optimize/certificate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "slam/base/error.h"
#include "slam/base/stopwatch.h"
#include "slam/graph/optimize/certificate_matrix.h"
#include "slam/graph/optimize/optimize.h"
#include "slam/graph/structure.h"
#include "slam/sparse/block_cholesky.h"

namespace ariadne::slam {
namespace {

/// The factor of an exactly singular matrix exists only if it is shifted by what rounding may take away.
constexpr double kRounding = 1e-15;  // of the scale of the matrix
constexpr int kMaxShifts = 60;

template <typename Pose>
constexpr int kD = Pose::Point::RowsAtCompileTime;

/// 1 for the entries of rotations, 0 for those of translations.
template <typename Pose>
Eigen::VectorXd RotationEntries(const BlockMatrix& S) {
  Eigen::VectorXd entries = Eigen::VectorXd::Ones(S.size());
  for (std::size_t i = 0; i < S.blocks(); ++i) entries[S.row(i)] = 0.0;
  return entries;
}

/// Whether the part of S that is left when the translations are eliminated has no eigenvalue below -shift:
/// whether S + shift is positive definite.
bool HoldsWithShift(const BlockMatrix& S, const Eigen::VectorXd& rotations, double shift,
                    BlockCholesky& factor) {
  BlockMatrix shifted = S;
  shifted.AddToDiagonal(shift * rotations);
  return factor.Factorize(shifted);
}

/// A shift with which S is positive definite: `least`, or within a tenth the smallest such shift.
double FindShift(const BlockMatrix& S, const Eigen::VectorXd& rotations, double least) {
  BlockCholesky factor(S);
  double shift = least;
  if (HoldsWithShift(S, rotations, shift, factor)) return shift;
  double failed = shift;
  for (int k = 0; !HoldsWithShift(S, rotations, shift *= 8.0, factor); ++k) {
    failed = shift;
    if (k == kMaxShifts) Fail("the certificate matrix is not finite");
  }
  while (shift > 1.1 * failed) {
    const double middle = std::sqrt(shift * failed);
    (HoldsWithShift(S, rotations, middle, factor) ? shift : failed) = middle;
  }
  return shift;
}

std::string Explain(const Certificate& certificate) {
  if (certificate.verdict == CertificateVerdict::kOptimal) {
    return fmt::format("optimal: no poses have an objective below {:.9g}, which is {:.2g} of it away",
                       certificate.lower_bound, certificate.relative_gap);
  }
  return fmt::format(
      "not certified: the certificate matrix has an eigenvalue of about {:.3g}; what is proven is only "
      "that no "
      "poses have an objective below {:.6g}; it may be a local minimum: start with graph.start=chordal",
      certificate.least_eigenvalue, certificate.lower_bound);
}

/// What the poses of `graph` prove about all poses.
struct Bound {
  double lower = 0.0;
  double least_eigenvalue = 0.0;
};

template <typename Pose>
Bound FindBound(const PoseGraph<Pose>& graph, double max_gap) {
  const CertificateMatrix matrix = MakeCertificateMatrix(graph);
  // With the translations eliminated, tr(Y S Y^T) >= -shift |Y|^2 = -shift d n for all rotations Y.
  const double dn = kD<Pose> * static_cast<double>(graph.nodes.size());
  const double least = std::max(0.1 * max_gap / dn, kRounding * matrix.scale);
  const double shift = FindShift(matrix.S, RotationEntries<Pose>(matrix.S), least);
  return {std::max(0.0, matrix.trace_of_multipliers - shift * dn), -shift};
}

template <typename Pose>
PoseGraph<Pose> Settled(const PoseGraph<Pose>& graph) {
  GraphOptions options;
  options.start = GraphStart::kGuess;
  options.convergence = 1e-13;
  options.max_iterations = 5;
  return Optimize(graph, options).graph;
}

}  // namespace

template <typename Pose>
Certificate Certify(const PoseGraph<Pose>& graph, double max_relative_gap) {
  const Stopwatch watch;
  CheckGraph(graph);
  if (!graph.priors.empty()) Fail("a graph with priors has no certificate: it is for relative poses alone");
  if (std::count_if(graph.nodes.begin(), graph.nodes.end(), [](const auto& node) { return node.fixed; }) >
      1)
    Fail("a graph with more than one fixed vertex has no certificate");
  Certificate certificate;
  certificate.objective = Objective(graph);
  const double max_gap = max_relative_gap * certificate.objective;
  Bound bound = FindBound(graph, max_gap);
  if (certificate.objective - bound.lower > max_gap) {
    const Bound settled = FindBound(Settled(graph), max_gap);
    if (settled.lower > bound.lower) bound = settled;
  }
  certificate.least_eigenvalue = bound.least_eigenvalue;
  certificate.lower_bound = std::min(bound.lower, certificate.objective);
  if (certificate.objective > 0.0)
    certificate.relative_gap = 1.0 - certificate.lower_bound / certificate.objective;
  if (certificate.relative_gap <= max_relative_gap) certificate.verdict = CertificateVerdict::kOptimal;
  certificate.message = Explain(certificate);
  certificate.seconds = watch.Seconds();
  return certificate;
}

template Certificate Certify(const PoseGraph2&, double);
template Certificate Certify(const PoseGraph3&, double);

}  // namespace ariadne::slam
