#include "experiments/mission/roomy_way.h"

#include <algorithm>
#include <utility>

#include "experiments/mission/clear_way.h"
#include "planning/path/geodesic.h"

namespace ariadne::experiments {
namespace {

using slam::Pose2;

constexpr double kLeadIn = 1.0;       // of a piece, before and after where there is too little room [m]
constexpr double kShortDetour = 1.0;  // is always worth it [m]

/// Poses of a path, the last one included.
struct Piece {
  std::size_t first = 0, last = 0;
};

/// The first piece from a pose on in which there is too little room, between two poses that have it; the
/// path's last pose: none.
Piece NextTightPiece(std::span<const Pose2> path, const std::vector<bool>& roomy, std::size_t from) {
  const std::size_t end = path.size() - 1;
  const auto next = [&](bool is_roomy, std::size_t i) {
    while (i < roomy.size() && roomy[i] != is_roomy) ++i;
    return i;
  };
  from = next(true, from);
  const std::size_t tight = next(false, from), after = next(true, tight);
  if (after > end) return {end, end};
  Piece piece{tight - 1, after};
  const auto length = [&](std::size_t a, std::size_t b) { return LengthOf(path.subspan(a, b - a + 1)); };
  while (piece.first > from && roomy[piece.first - 1] && length(piece.first, tight) < kLeadIn)
    --piece.first;
  while (piece.last < end && roomy[piece.last + 1] && length(after, piece.last) < kLeadIn) ++piece.last;
  return piece;
}

/// The piece with more room; empty where there is no such way that is short enough.
std::vector<Pose2> Widened(const planning::FreeSpace& space, std::span<const Pose2> piece,
                           const planning::PathOptions& options, double detour, std::uint64_t seed) {
  const double longest = detour * LengthOf(piece) + kShortDetour;
  const planning::Footprint robot(options.footprint);
  const planning::GeodesicField ways =
      planning::DistancesFrom(space, robot.CentreAt(piece.front()), robot.least_radius());
  if (!(ways.To(robot.CentreAt(piece.back())) <= longest)) return {};
  planning::PathResult path = planning::PlanPath(space, piece.front(), piece.back(), options, seed);
  if (path.status != planning::PathStatus::kFound || path.length > longest) return {};
  return std::move(path.poses);
}

std::vector<Pose2> WithMargin(const planning::FreeSpace& space, std::vector<Pose2> path,
                              const planning::PathOptions& options, double detour, std::uint64_t seed) {
  const planning::Footprint robot(options.footprint);
  std::vector<bool> roomy(path.size());
  for (std::size_t i = 0; i < path.size(); ++i) roomy[i] = robot.IsFree(space, path[i]);
  std::vector<Pose2> result;
  std::size_t done = 0;
  while (done + 1 < path.size()) {
    const Piece piece = NextTightPiece(path, roomy, done);
    result.insert(result.end(), path.begin() + static_cast<std::ptrdiff_t>(done),
                  path.begin() + static_cast<std::ptrdiff_t>(piece.first));
    const std::span<const Pose2> tight(path.data() + piece.first, piece.last - piece.first + 1);
    if (tight.size() > 1) {
      const std::vector<Pose2> wide = Widened(space, tight, options, detour, seed);
      const std::span<const Pose2> taken = wide.empty() ? tight : std::span<const Pose2>(wide);
      result.insert(result.end(), taken.begin(), taken.end() - 1);
    }
    done = piece.last;
  }
  result.push_back(path.back());
  return result;
}

}  // namespace

std::vector<Pose2> WithRoom(const planning::FreeSpace& space, std::vector<Pose2> path_map,
                            const planning::PathOptions& options, const RoomOptions& room,
                            std::uint64_t seed) {
  const double own = options.footprint.margin;
  if (path_map.empty() || room.margin <= own) return path_map;
  planning::PathOptions roomier = options;
  for (const double margin : {room.margin, 0.5 * (room.margin + own)}) {
    roomier.footprint.margin = margin;
    path_map = WithMargin(space, std::move(path_map), roomier, room.detour, seed);
  }
  return path_map;
}

}  // namespace ariadne::experiments
