#include "planning/polygon/visible_pieces.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ariadne::planning {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kEndOn = 1e-4;        // what the docstring promises [rad]
constexpr double kAtScanner = 0.01;    // the same [m]
constexpr double kSameBearing = 1e-7;  // a micrometre at 10 m [rad]

Eigen::Vector2d Towards(double bearing) { return {std::cos(bearing), std::sin(bearing)}; }

/// A line over the bearings that it spans. With `inverse` w, the points p of the line are those with
/// w . p = 1, and along a unit vector u it lies at range 1 / (w . u): the nearest line has the largest w .
/// u.
struct BearingSpan {
  std::size_t line = 0;
  double right = 0.0, left = 0.0;
  Eigen::Vector2d inverse = Eigen::Vector2d::Zero();
};

double DistanceFromScanner(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d along = b - a;
  const double t = along.squaredNorm() > 0.0 ? -a.dot(along) / along.squaredNorm() : 0.0;
  return (a + std::clamp(t, 0.0, 1.0) * along).norm();
}

std::vector<BearingSpan> SpansOf(std::span<const SliceLine> lines_scan) {
  std::vector<BearingSpan> spans;
  for (std::size_t i = 0; i < lines_scan.size(); ++i) {
    Eigen::Vector2d right = lines_scan[i].from_scan;
    Eigen::Vector2d left = lines_scan[i].to_scan;
    double cross = right.x() * left.y() - right.y() * left.x();
    if (cross < 0.0) std::swap(right, left);
    cross = std::abs(cross);
    const double angle = std::atan2(cross, right.dot(left));
    if (angle < kEndOn || DistanceFromScanner(right, left) < kAtScanner) continue;
    const Eigen::Vector2d inverse = Eigen::Vector2d(left.y() - right.y(), right.x() - left.x()) / cross;
    const double from = std::atan2(right.y(), right.x());
    const double to = std::atan2(left.y(), left.x());
    if (from < to) {
      spans.push_back({i, from, to, inverse});
    } else {  // across the direction behind the scanner
      spans.push_back({i, -kPi, to, inverse});
      spans.push_back({i, from, kPi, inverse});
    }
  }
  return spans;
}

/// The bearings of all ends, ascending. Ends that are the same to rounding become so.
std::vector<double> SnapEnds(std::vector<BearingSpan>& spans) {
  std::vector<double*> ends;
  for (BearingSpan& span : spans) {
    ends.push_back(&span.right);
    ends.push_back(&span.left);
  }
  std::ranges::sort(ends, [](const double* a, const double* b) { return *a < *b; });
  std::vector<double> bearings;
  for (double* end : ends) {
    if (bearings.empty() || *end - bearings.back() > kSameBearing) bearings.push_back(*end);
    *end = bearings.back();
  }
  return bearings;
}

/// A span between two rays. Over the chord from one ray's unit vector to the other's the inverse range is
/// proportional to a straight line, so that the nearest spans are an upper envelope of straight lines.
struct InverseRange {
  const BearingSpan* span;
  double at_right, at_left;
};

/// Where along the chord `other` comes before `nearest`; beyond 1: nowhere.
double Overtakes(const InverseRange& nearest, const InverseRange& other) {
  const double behind = nearest.at_right - other.at_right;
  const double ahead = other.at_left - nearest.at_left;
  return ahead > 0.0 ? std::max(behind, 0.0) / (std::max(behind, 0.0) + ahead) : 2.0;
}

/// Continues the last piece where it is of the same line and ends where this one begins.
void AppendPiece(const BearingSpan& span, double right, double left, std::vector<VisiblePiece>& pieces) {
  if (left - right <= 0.0) return;
  const auto at = [&](double bearing) -> Eigen::Vector2d {
    return Towards(bearing) / span.inverse.dot(Towards(bearing));
  };
  if (!pieces.empty() && pieces.back().line == span.line && pieces.back().left == right) {
    pieces.back().left = left;
    pieces.back().left_scan = at(left);
  } else {
    pieces.push_back({span.line, right, left, at(right), at(left)});
  }
}

/// The nearest of spans that all reach from one bearing to the other: walks along the envelope, from one
/// line to the next that overtakes it.
void AppendNearest(const std::vector<const BearingSpan*>& spans, double right, double left,
                   std::vector<VisiblePiece>& pieces) {
  const Eigen::Vector2d u_right = Towards(right);
  const Eigen::Vector2d u_left = Towards(left);
  std::vector<InverseRange> ranges;
  for (const BearingSpan* span : spans) {
    ranges.push_back({span, span->inverse.dot(u_right), span->inverse.dot(u_left)});
  }
  const InverseRange* nearest = &*std::ranges::max_element(
      ranges, {}, [](const InverseRange& r) { return std::pair(r.at_right, r.at_left); });
  double begin = right;
  for (;;) {
    const InverseRange* next = &*std::ranges::min_element(ranges, {}, [&](const InverseRange& other) {
      return std::pair(Overtakes(*nearest, other), -other.at_left);
    });
    const double share = Overtakes(*nearest, *next);
    if (share >= 1.0) break;
    const Eigen::Vector2d u = (1.0 - share) * u_right + share * u_left;
    const double end = std::clamp(std::atan2(u.y(), u.x()), begin, left);
    AppendPiece(*nearest->span, begin, end, pieces);
    begin = end;
    nearest = next;
  }
  AppendPiece(*nearest->span, begin, left, pieces);
}

}  // namespace

std::vector<VisiblePiece> VisiblePieces(std::span<const SliceLine> lines_scan) {
  std::vector<BearingSpan> spans = SpansOf(lines_scan);
  const std::vector<double> bearings = SnapEnds(spans);
  std::ranges::stable_sort(spans, {}, &BearingSpan::right);
  std::vector<VisiblePiece> pieces;
  std::vector<const BearingSpan*> spanning;  // those that reach over the bearings at hand
  std::size_t begun = 0;
  for (std::size_t k = 0; k + 1 < bearings.size(); ++k) {
    std::erase_if(spanning, [&](const BearingSpan* span) { return span->left <= bearings[k]; });
    for (; begun < spans.size() && spans[begun].right <= bearings[k]; ++begun) {
      if (spans[begun].left > bearings[k]) spanning.push_back(&spans[begun]);
    }
    if (!spanning.empty()) AppendNearest(spanning, bearings[k], bearings[k + 1], pieces);
  }
  return pieces;
}

}  // namespace ariadne::planning
