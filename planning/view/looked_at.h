#pragma once

#include <map>
#include <utility>
#include <vector>

#include "planning/view/ray_gain.h"
#include "slam/geometry/pose2.h"

namespace ariadne::planning {

/// Which unseen edges earlier scans have looked at in vain: a window, a hall wider than the range, a
/// surface that sends no light back. They would promise the same gain for ever.
class LookedAt {
 public:
  /// A scan has looked at a piece of an edge (of that length [m]) if one of its rays meets it first, at
  /// more than 10 degrees: edges along a ray join what was seen nearer to what was seen farther.
  LookedAt(std::span<const Edge> edges, std::span<const slam::Pose2> T_map_scans,
           const RayGainOptions& options, double piece_length);

  /// Whether a ray that meets an unseen edge may find more than was found: it is nearer than `share` of the
  /// distance of any scan that has looked there, or meets the edge twice as steeply. (Edges along a ray
  /// join what that scan saw nearer to what it saw farther: from the side they are worth a look.)
  bool IsWorth(const Eigen::Vector2d& p_map, const Eigen::Vector2d& direction, const RayHit& hit,
               double share) const;

 private:
  using Piece = std::pair<std::size_t, long>;
  Piece PieceOf(std::size_t edge, const Eigen::Vector2d& p_map) const;

  std::span<const Edge> edges_;
  double piece_length_;
  struct Look {
    double distance = 0.0;  // [m]
    double sine = 0.0;      // of the angle between ray and edge
  };
  std::map<Piece, std::vector<Look>> looks_;
};

}  // namespace ariadne::planning
