#include "planning/polygon/slice_polygon.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "planning/polygon/visible_pieces.h"
#include "slam/base/error.h"
#include "slam/geometry/angles.h"

namespace ariadne::planning {
namespace {

constexpr double kSamePlace = 1e-9;                       // of ends that differ by rounding alone [m]
constexpr double kHalfTurn = std::numbers::pi - 1e-6;     // a chord nearer to the scanner is no area [rad]
constexpr double kLeastFree = 4e-3;                       // what a beam of half a degree may pass by [rad]
constexpr double kWidestChord = std::numbers::pi / 36.0;  // [rad]

void RequireFiniteLines(std::span<const SliceLine> lines, const slam::Pose2& T_map_scan) {
  if (!std::isfinite(T_map_scan.angle) || !T_map_scan.translation.allFinite()) {
    Fail("the pose of a slice is NaN or infinite");
  }
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].from_scan.allFinite() && lines[i].to_scan.allFinite()) continue;
    Fail("line {} of a slice has an end that is NaN or infinite; leave it out", i);
  }
}

/// Makes one piece of a line across the direction behind the scanner. True where there was one.
bool JoinBehind(std::vector<VisiblePiece>& pieces) {
  if (pieces.size() < 2 || pieces.front().line != pieces.back().line) return false;
  if ((pieces.front().right_scan - pieces.back().left_scan).norm() > kSamePlace) return false;
  pieces.back().left = pieces.front().left + 2.0 * std::numbers::pi;
  pieces.back().left_scan = pieces.front().left_scan;
  pieces.erase(pieces.begin());
  return true;
}

/// The corners of a polygon about the scanner, one after another.
class RingAround {
 public:
  RingAround(const slam::Pose2& T_map_scan, const SlicePolygonOptions& options)
      : T_map_scan_(T_map_scan), options_(options) {}

  /// `seen` is what the edge from here on is.
  void Add(const Eigen::Vector2d& p_scan, bool seen) { ring_.push_back({T_map_scan_ * p_scan, seen}); }

  /// Through directions in which there is nothing, as far as that is free [rad].
  void AddFree(double right, double left) {
    if (options_.free_range == 0.0 || left - right < kLeastFree) return;
    const int chords = static_cast<int>(std::ceil((left - right) / kWidestChord));
    for (int k = 0; k <= chords; ++k) {
      const double bearing = right + (left - right) * k / chords;
      Add(options_.free_range * Eigen::Vector2d(std::cos(bearing), std::sin(bearing)), false);
    }
  }

  /// From the left end of the field of view by the scanner to its right end.
  void AddBehind(double left_end, double right_end) {
    const double half = std::min(0.5 * slam::RadFromDeg(options_.field_of_view), std::numbers::pi);
    AddFree(left_end, half);
    Add(Eigen::Vector2d::Zero(), false);
    AddFree(-half, right_end);
  }

  LabelledRing Take() {
    const auto is_same = [](const LabelledCorner& a, const LabelledCorner& b) {
      return !a.seen && (a.p_map - b.p_map).norm() <= kSamePlace;
    };
    LabelledRing ring;
    for (std::size_t i = 0; i < ring_.size(); ++i) {  // an edge without length says nothing
      if (!is_same(ring_[i], ring_[(i + 1) % ring_.size()])) ring.push_back(ring_[i]);
    }
    return ring;
  }

 private:
  const slam::Pose2& T_map_scan_;
  const SlicePolygonOptions& options_;
  LabelledRing ring_;
};

/// Where no line was found at all.
LabelledPolygon FreeAround(const slam::Pose2& T_map_scan, const SlicePolygonOptions& options) {
  RingAround ring(T_map_scan, options);
  const double half = std::min(0.5 * slam::RadFromDeg(options.field_of_view), std::numbers::pi);
  if (options.free_range == 0.0) return {};
  ring.AddFree(-half, half);
  if (half < std::numbers::pi) ring.Add(Eigen::Vector2d::Zero(), false);
  return {ring.Take(), {}};
}

}  // namespace

LabelledPolygon SlicePolygon(std::span<const SliceLine> lines_scan, const slam::Pose2& T_map_scan,
                             const SlicePolygonOptions& options) {
  RequireFiniteLines(lines_scan, T_map_scan);
  std::vector<VisiblePiece> pieces = VisiblePieces(lines_scan);
  if (pieces.empty()) return FreeAround(T_map_scan, options);
  const bool closed_behind = JoinBehind(pieces);
  RingAround ring(T_map_scan, options);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const bool last = i + 1 == pieces.size();
    const VisiblePiece& piece = pieces[i];
    const VisiblePiece& next = pieces[last ? 0 : i + 1];
    ring.Add(piece.right_scan, true);
    if ((next.right_scan - piece.left_scan).norm() <= kSamePlace) continue;
    ring.Add(piece.left_scan, false);
    const double to = next.right + (last ? 2.0 * std::numbers::pi : 0.0);
    if (last && !closed_behind && options.closure == PolygonClosure::kThroughScanner) {
      ring.AddBehind(piece.left, next.right);
    } else if (options.free_range > 0.0) {
      ring.AddFree(piece.left, to);
    } else if (to - piece.left >= kHalfTurn) {
      ring.Add(Eigen::Vector2d::Zero(), false);
    }
  }
  return {ring.Take(), {}};
}

}  // namespace ariadne::planning
