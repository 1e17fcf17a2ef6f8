#include "experiments/bounds/improved_tour.h"

#include <algorithm>
#include <limits>

namespace ariadne::experiments {
namespace {

using Order = std::vector<std::size_t>;

constexpr double kLeastGain = 1e-9;  // [m]; less is rounding, with which one could go in circles
constexpr std::size_t kLongestPart = 3;

class TourMoves {
 public:
  explicit TourMoves(const Eigen::MatrixXd& distances) : distances_(distances) {}

  void Improve(Order& order) const {
    while (Reverse(order) || Shift(order)) {
    }
  }

 private:
  /// Between the places at two positions; there is nothing to go to behind the last.
  double Between(const Order& order, std::size_t a, std::size_t b) const {
    if (b >= order.size()) return 0.0;
    return distances_(static_cast<Eigen::Index>(order[a]), static_cast<Eigen::Index>(order[b]));
  }

  bool Reverse(Order& order) const {
    for (std::size_t first = 1; first + 1 < order.size(); ++first) {
      for (std::size_t last = first + 1; last < order.size(); ++last) {
        const double before = Between(order, first - 1, first) + Between(order, last, last + 1);
        const double after = Between(order, first - 1, last) + Between(order, first, last + 1);
        if (after > before - kLeastGain) continue;
        std::reverse(order.begin() + Offset(first), order.begin() + Offset(last + 1));
        return true;
      }
    }
    return false;
  }

  bool Shift(Order& order) const {
    for (std::size_t count = 1; count <= kLongestPart; ++count) {
      for (std::size_t first = 1; first + count <= order.size(); ++first) {
        if (ShiftPart(order, first, count)) return true;
      }
    }
    return false;
  }

  /// Puts positions first .. first + count - 1 behind the place where that helps most.
  bool ShiftPart(Order& order, std::size_t first, std::size_t count) const {
    const std::size_t next = first + count;
    const double saved =
        Between(order, first - 1, first) + Between(order, next - 1, next) - Between(order, first - 1, next);
    Order rest(order.begin(), order.begin() + Offset(first));
    rest.insert(rest.end(), order.begin() + Offset(next), order.end());
    Order part(order.begin() + Offset(first), order.begin() + Offset(next));
    double best_gain = kLeastGain;
    std::size_t best_at = 0;
    bool best_reversed = false;
    for (std::size_t at = 1; at <= rest.size(); ++at) {
      for (const bool reversed : {false, true}) {
        const double gain = saved - Inserted(rest, at, reversed ? part.back() : part.front(),
                                             reversed ? part.front() : part.back());
        if (gain <= best_gain) continue;
        best_gain = gain, best_at = at, best_reversed = reversed;
      }
    }
    if (best_at == 0) return false;
    if (best_reversed) std::reverse(part.begin(), part.end());
    rest.insert(rest.begin() + Offset(best_at), part.begin(), part.end());
    order = rest;
    return true;
  }

  /// How much longer the rest becomes with a part from `head` to `tail` before position `at`.
  double Inserted(const Order& rest, std::size_t at, std::size_t head, std::size_t tail) const {
    const auto distance = [&](std::size_t a, std::size_t b) {
      return distances_(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b));
    };
    const double to_head = distance(rest[at - 1], head);
    if (at == rest.size()) return to_head;
    return to_head + distance(tail, rest[at]) - distance(rest[at - 1], rest[at]);
  }

  static std::ptrdiff_t Offset(std::size_t position) { return static_cast<std::ptrdiff_t>(position); }

  const Eigen::MatrixXd& distances_;
};

Order NearestNeighborTour(const Eigen::MatrixXd& distances, std::size_t start, std::size_t second) {
  Order order{start, second};
  std::vector<bool> visited(static_cast<std::size_t>(distances.rows()), false);
  visited[start] = visited[second] = true;
  while (order.size() < visited.size()) {
    std::size_t nearest = visited.size();
    for (std::size_t i = 0; i < visited.size(); ++i) {
      if (visited[i]) continue;
      const auto column = distances.col(static_cast<Eigen::Index>(order.back()));
      if (nearest == visited.size() ||
          column[static_cast<Eigen::Index>(i)] < column[static_cast<Eigen::Index>(nearest)]) {
        nearest = i;
      }
    }
    visited[nearest] = true;
    order.push_back(nearest);
  }
  return order;
}

}  // namespace

std::vector<std::size_t> ImprovedTour(const Eigen::MatrixXd& distances, std::size_t start) {
  const TourMoves moves(distances);
  Order best{start};
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t second = 0; second < static_cast<std::size_t>(distances.rows()); ++second) {
    if (second == start) continue;
    Order order = NearestNeighborTour(distances, start, second);
    moves.Improve(order);
    const double length = LengthOf(distances, order);
    if (length >= shortest) continue;
    shortest = length;
    best = order;
  }
  return best;
}

double LengthOf(const Eigen::MatrixXd& distances, const std::vector<std::size_t>& order) {
  double length = 0.0;
  for (std::size_t k = 1; k < order.size(); ++k) {
    length += distances(static_cast<Eigen::Index>(order[k - 1]), static_cast<Eigen::Index>(order[k]));
  }
  return length;
}

}  // namespace ariadne::experiments
