#include "slam/matching/match.h"

#include <algorithm>

#include "slam/matching/match_context.h"
#include "slam/matching/match_graph.h"
#include "slam/matching/match_joint.h"
#include "slam/matching/match_queue.h"

namespace ariadne::slam {
namespace {

MatchResult MatchToMetascan(const MatchContext& c) {
  std::vector<std::size_t> earlier;
  for (std::size_t i = 0; i + 1 < c.map.scans.size(); ++i) {
    if (c.map.scans[i].registered) earlier.push_back(i);
  }
  return MatchOnce(c, std::move(earlier));
}

MatchResult Dispatch(const MatchContext& c) {
  const std::vector<MapScan>& scans = c.map.scans;
  const bool any =
      std::any_of(scans.begin(), scans.end() - 1, [](const MapScan& s) { return s.registered; });
  if (!any) return Unmatched("no scan is registered yet");
  if (scans.back().points_laser.empty()) return Unmatched("the scan has no points");
  switch (c.match.method) {
    case MatchMethod::kPairwise:
      return MatchPairwise(c);
    case MatchMethod::kMetascan:
      return MatchToMetascan(c);
    case MatchMethod::kSimultaneous:
      return MatchByQueue(c);
    case MatchMethod::kGraph:
      return MatchByGraph(c);
    case MatchMethod::kJoint:
      return MatchJointly(c);
  }
  return {};
}

}  // namespace

MatchResult MatchNewScan(ScanMap& map, const MatchOptions& match, const AlignOptions& align,
                         const MatchCallback& on_progress) {
  const Pose3 T_map_laser_guess = map.scans.back().T_map_laser;
  MatchResult result = Dispatch({map, match, align, on_progress, Parallel(align.threads)});
  result.T_map_laser_guess = T_map_laser_guess;
  return result;
}

MatchResult FinishMatching(ScanMap& map, const MatchOptions& match, const AlignOptions& align) {
  const MatchCallback no_progress;
  const MatchContext c{map, match, align, no_progress, Parallel(align.threads)};
  return match.method == MatchMethod::kJoint ? FinishJointly(c) : MatchResult();
}

}  // namespace ariadne::slam
