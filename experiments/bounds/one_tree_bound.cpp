#include "experiments/bounds/one_tree_bound.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace ariadne::experiments {
namespace {

constexpr int kRounds = 300;

struct SpanningTree {
  double length = 0.0;
  Eigen::VectorXi degrees;
};

/// Prim's algorithm; `prices` of both ends are added to each edge.
SpanningTree ShortestSpanningTree(const Eigen::MatrixXd& distances, const Eigen::VectorXd& prices) {
  const Eigen::Index count = distances.rows();
  SpanningTree tree{0.0, Eigen::VectorXi::Zero(count)};
  std::vector<Eigen::Index> parent(static_cast<std::size_t>(count), 0);
  Eigen::VectorXd cost = (distances.col(0) + prices).array() + prices[0];
  std::vector<bool> inside(static_cast<std::size_t>(count), false);
  inside[0] = true;
  for (Eigen::Index added = 1; added < count; ++added) {
    Eigen::Index next = -1;
    for (Eigen::Index i = 0; i < count; ++i) {
      if (!inside[static_cast<std::size_t>(i)] && (next < 0 || cost[i] < cost[next])) next = i;
    }
    inside[static_cast<std::size_t>(next)] = true;
    tree.length += cost[next];
    ++tree.degrees[next];
    ++tree.degrees[parent[static_cast<std::size_t>(next)]];
    for (Eigen::Index i = 0; i < count; ++i) {
      const double through = distances(next, i) + prices[next] + prices[i];
      if (inside[static_cast<std::size_t>(i)] || through >= cost[i]) continue;
      cost[i] = through;
      parent[static_cast<std::size_t>(i)] = next;
    }
  }
  return tree;
}

}  // namespace

double OneTreeBound(const Eigen::MatrixXd& distances, std::size_t start, double length) {
  const Eigen::Index count = distances.rows();
  // A tour has degree 1 at the start and 2 elsewhere, but 1 at its end, wherever that is.
  Eigen::VectorXd prices = Eigen::VectorXd::Zero(count);
  Eigen::VectorXi wanted = Eigen::VectorXi::Constant(count, 2);
  wanted[static_cast<Eigen::Index>(start)] = 1;
  double bound = 0.0;
  for (int round = 0; round < kRounds; ++round) {
    const SpanningTree tree = ShortestSpanningTree(distances, prices);
    // The prices that a tour pays depend on its end, which pays once: at least the lowest.
    Eigen::Index end = -1;
    for (Eigen::Index i = 0; i < count; ++i) {
      if (i != static_cast<Eigen::Index>(start) && (end < 0 || prices[i] < prices[end])) end = i;
    }
    const double paid = prices.dot(wanted.cast<double>());
    bound = std::max(bound, tree.length - paid + prices[end]);
    Eigen::VectorXd slope = (tree.degrees - wanted).cast<double>();
    slope[end] += 1.0;
    if (slope.isZero(0.0)) break;
    prices += (length - bound) * 0.97 / (1.0 + 0.02 * round) / slope.squaredNorm() * slope;
  }
  return bound;
}

}  // namespace ariadne::experiments
