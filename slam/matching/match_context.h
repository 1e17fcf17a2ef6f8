#pragma once

#include <string>
#include <vector>

#include "slam/matching/match.h"

/// What the methods of matching share; for the files of this folder.
namespace ariadne::slam {

/// The map, the options, and where progress goes.
struct MatchContext {
  ScanMap& map;
  const MatchOptions& match;
  const AlignOptions& align;
  const MatchCallback& on_progress;
  Parallel parallel;
};

/// Whether a scan may be moved to where an alignment has brought it.
bool MayMove(const AlignResult& result);

/// Aligns a scan to the union of its partners, from where it is, without moving it.
MatchStep AlignToUnion(const MatchContext& c, std::size_t scan, std::vector<std::size_t> partners,
                       std::size_t queued, const AlignOptions& align);

/// The same, and moves the scan there, unless that fails.
MatchStep MoveToUnion(const MatchContext& c, std::size_t scan, std::vector<std::size_t> partners,
                      std::size_t queued);

/// Moves a scan, and notes how far.
void MoveInPass(MapScan& scan, const Pose3& T_map_laser, MatchPass& pass);

MatchResult Unmatched(std::string message);

/// Aligns the new scan to the given partners.
MatchResult MatchOnce(const MatchContext& c, std::vector<std::size_t> partners);

/// A registered scan, and how many points of another one have a pair in it.
struct Overlap {
  std::size_t scan = 0;
  std::size_t pairs = 0;
};

/// Of all registered scans with the new one, the largest first; without those that have no pair.
std::vector<Overlap> FindOverlaps(const MatchContext& c);

/// Whether it is enough for the options.
bool IsEnough(const MatchContext& c, const Overlap& overlap);

/// Nothing was aligned, as no overlap is enough.
MatchResult WithoutOverlap(const MatchContext& c, const std::vector<Overlap>& overlaps);

/// Aligns the new scan to the earlier one with the largest overlap (Sec. 3.2).
MatchResult MatchPairwise(const MatchContext& c);

/// Aligns the new scan to the union of those that it overlaps, the largest overlap first; with no more
/// digits than what follows, in the methods graph and joint, can add (start_step).
MatchResult MatchToOverlapping(const MatchContext& c);

}  // namespace ariadne::slam
