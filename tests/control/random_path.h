#pragma once

#include <cmath>
#include <vector>

#include "slam/base/random.h"
#include "slam/geometry/pose2.h"

namespace ariadne::control {

/// One piece of a path: an arc or a line, forward or backward, or a turn in place.
struct PathPiece {
  double way = 0.0;   // [m]; negative backward
  double turn = 0.0;  // [rad]
};

/// Poses along the pieces, at most `step` [m] or 2 `step` [rad] apart; ends of pieces are among them.
inline std::vector<slam::Pose2> PathOf(const slam::Pose2& start, const std::vector<PathPiece>& pieces,
                                       double step = 0.05) {
  std::vector<slam::Pose2> path{start};
  for (const PathPiece& piece : pieces) {
    const slam::Pose2 from = path.back();
    const int count = static_cast<int>(
        std::ceil(std::max({std::abs(piece.way), 0.5 * std::abs(piece.turn), 1e-9}) / step));
    for (int i = 1; i <= count; ++i) {
      const double share = static_cast<double>(i) / count;
      path.push_back(from * slam::Pose2::Exp({share * piece.way, 0.0, share * piece.turn}));
    }
  }
  return path;
}

/// Like a path of Reeds and Shepp: arcs of one radius and lines, with cusps, and sometimes a turn in place.
inline std::vector<PathPiece> DrawPieces(RandomStream& stream) {
  const double radius = DrawUniform(stream, 0.3, 0.8);
  const int count = 1 + static_cast<int>(DrawUniform(stream, 0.0, 5.0));
  std::vector<PathPiece> pieces;
  for (int i = 0; i < count; ++i) {
    const double turn = DrawUniform(stream, -2.0, 2.0);
    const double sense = DrawUniform(stream, 0.0, 1.0) < 0.6 ? 1.0 : -1.0;
    const double kind = DrawUniform(stream, 0.0, 1.0);
    if (kind < 0.5) pieces.push_back({sense * radius * std::abs(turn), turn});
    if (kind >= 0.5 && kind < 0.9) pieces.push_back({sense * DrawUniform(stream, 0.02, 2.0), 0.0});
    if (kind >= 0.9) pieces.push_back({0.0, 1.5 * turn});
  }
  return pieces;
}

}  // namespace ariadne::control
