#include "planning/polygon/slice_polygon.h"

#include <cmath>
#include <numbers>

#include "planning/polygon/visible_pieces.h"
#include "slam/base/error.h"

namespace ariadne::planning {
namespace {

constexpr double kSamePlace = 1e-9;                    // of ends that differ by rounding alone [m]
constexpr double kHalfTurn = std::numbers::pi - 1e-6;  // a chord nearer to the scanner is no area [rad]

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

}  // namespace

LabelledPolygon SlicePolygon(std::span<const SliceLine> lines_scan, const slam::Pose2& T_map_scan,
                             const SlicePolygonOptions& options) {
  RequireFiniteLines(lines_scan, T_map_scan);
  std::vector<VisiblePiece> pieces = VisiblePieces(lines_scan);
  const bool closed_behind = JoinBehind(pieces);
  LabelledPolygon polygon;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const bool last = i + 1 == pieces.size();
    const VisiblePiece& piece = pieces[i];
    const VisiblePiece& next = pieces[last ? 0 : i + 1];
    polygon.outer.push_back({T_map_scan * piece.right_scan, true});
    if ((next.right_scan - piece.left_scan).norm() <= kSamePlace) continue;
    polygon.outer.push_back({T_map_scan * piece.left_scan, false});
    const double gap = next.right - piece.left + (last ? 2.0 * std::numbers::pi : 0.0);
    const bool behind = last && !closed_behind && options.closure == PolygonClosure::kThroughScanner;
    if (behind || gap >= kHalfTurn) polygon.outer.push_back({T_map_scan.translation, false});
  }
  return polygon;
}

}  // namespace ariadne::planning
