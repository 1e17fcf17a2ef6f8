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

/// 1 for the entries of rotations, 0 for those of translations.
Eigen::VectorXd RotationEntries(const BlockMatrix& S) {
  Eigen::VectorXd entries = Eigen::VectorXd::Ones(S.size());
  for (std::size_t i = 0; i < S.blocks(); ++i) entries[S.row(i)] = 0.0;
  return entries;
}

/// What poses prove about all poses.
struct Bound {
  double lower = 0.0;
  double least_eigenvalue = 0.0;
};

/// The certificate matrix of some poses, and for which shifts it is positive definite.
class Prover {
 public:
  template <typename Pose>
  explicit Prover(const PoseGraph<Pose>& graph)
      : matrix_(MakeCertificateMatrix(graph)),
        rotations_(RotationEntries(matrix_.S)),
        factor_(matrix_.S),
        dn_(static_cast<double>(Pose::Point::RowsAtCompileTime * graph.nodes.size())) {}

  /// The shift by which the bound falls short of the objective by `gap`, or what rounding asks for.
  double ShiftOfGap(double gap) const { return std::max(gap / dn_, kRounding * matrix_.scale); }

  /// Whether the part of S that is left when the translations are eliminated has no eigenvalue below
  /// -shift: whether S + shift is positive definite.
  bool Holds(double shift) {
    BlockMatrix shifted = matrix_.S;
    shifted.AddToDiagonal(shift * rotations_);
    return factor_.Factorize(shifted);
  }

  /// Within a tenth the smallest shift that holds; `failed` does not.
  double FindShift(double failed) {
    double shift = 8.0 * failed;
    for (int k = 0; !Holds(shift); ++k, shift *= 8.0) {
      failed = shift;
      if (k == kMaxShifts) Fail("the certificate matrix is not finite");
    }
    while (shift > 1.1 * failed) {
      const double middle = std::sqrt(shift * failed);
      (Holds(middle) ? shift : failed) = middle;
    }
    return shift;
  }

  /// With the translations eliminated, tr(Y S Y^T) >= -shift |Y|^2 = -shift d n for all rotations Y.
  Bound BoundOf(double shift) const {
    return {std::max(0.0, matrix_.trace_of_multipliers - shift * dn_), -shift};
  }

 private:
  CertificateMatrix matrix_;
  Eigen::VectorXd rotations_;
  BlockCholesky factor_;
  double dn_;
};

std::string Explain(const Certificate& certificate) {
  if (certificate.verdict == CertificateVerdict::kOptimal) {
    return fmt::format("optimal: no poses have an objective below {:.9g}, which is {:.2g} of it away",
                       certificate.lower_bound, certificate.relative_gap);
  }
  return fmt::format(
      "not certified: the certificate matrix has an eigenvalue of about {:.3g}; what is proven is only "
      "that "
      "no poses have an objective below {:.6g}; it may be a local minimum: start with graph.start=chordal",
      certificate.least_eigenvalue, certificate.lower_bound);
}

template <typename Pose>
PoseGraph<Pose> Settled(const PoseGraph<Pose>& graph) {
  GraphOptions options;
  options.start = GraphStart::kGuess;
  options.convergence = 1e-13;
  options.max_iterations = 5;
  return Optimize(graph, options).graph;
}

/// A bound within `max_gap` of the objective of these poses, else the best that there is.
template <typename Pose>
Bound FindBound(const PoseGraph<Pose>& graph, double objective, double max_gap) {
  Prover prover(graph);
  const double shift = prover.ShiftOfGap(0.1 * max_gap);
  const Bound first = prover.BoundOf(shift);
  // Where poses are only near a minimum, the multipliers fall short of the objective.
  if (objective - first.lower <= max_gap && prover.Holds(shift)) return first;
  Prover settled(Settled(graph));
  return settled.BoundOf(settled.Holds(shift) ? shift : settled.FindShift(shift));
}

}  // namespace

template <typename Pose>
Certificate Certify(const PoseGraph<Pose>& graph, double max_relative_gap) {
  const Stopwatch watch;
  CheckGraph(graph);
  if (!graph.priors.empty()) Fail("a graph with priors has no certificate: it is for relative poses alone");
  if (std::ranges::count_if(graph.nodes, [](const auto& node) { return node.fixed; }) > 1)
    Fail("a graph with more than one fixed vertex has no certificate");
  Certificate certificate;
  certificate.objective = Objective(graph);
  // No objective is below zero, which proves poses that fulfil all edges to rounding without any matrix.
  const double max_gap = max_relative_gap * certificate.objective;
  const Bound bound = certificate.objective <= NegligibleObjective(graph)
                          ? Bound{certificate.objective, 0.0}
                          : FindBound(graph, certificate.objective, max_gap);
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
