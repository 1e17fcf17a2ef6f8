#include "slam/matching/match_queue.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>

namespace ariadne::slam {
namespace {

/// One round of the queue (Sec. 3.2, step 3): aligns `current` to its neighbours, and queues them if it has
/// moved.
MatchStep PopCurrent(const MatchContext& c, std::size_t current, const std::vector<std::size_t>& neighbors,
                     std::deque<std::size_t>& queue) {
  MatchStep step = MoveToUnion(c, current, neighbors, queue.size());
  const bool moved = MayMove(step.align) && (step.moved_translation > c.match.moved_translation ||
                                             step.moved_rotation > c.match.moved_rotation);
  if (!moved) return step;
  for (const std::size_t neighbor : neighbors) {
    if (std::find(queue.begin(), queue.end(), neighbor) != queue.end()) continue;
    queue.push_back(neighbor);
    step.requeued.push_back(neighbor);
  }
  return step;
}

}  // namespace

MatchResult MatchByQueue(const MatchContext& c) {
  constexpr std::size_t kMaster = 0;  // fixed; it defines the map's coordinate system
  MatchResult result = MatchPairwise(c);
  if (!result.registered) return result;
  const std::vector<MapScan>& scans = c.map.scans;
  std::deque<std::size_t> queue{scans.size() - 1};
  const std::size_t max_pops = static_cast<std::size_t>(c.match.max_pops) * scans.size();
  std::size_t pops = 0;
  for (; !queue.empty() && pops < max_pops; ++pops) {
    const std::size_t current = queue.front();
    queue.pop_front();
    if (current == kMaster) continue;  // nothing is aligned, so nothing has moved
    const std::vector<std::size_t> neighbors =
        FindOverlapping(scans, current, static_cast<std::size_t>(c.match.overlap_pairs),
                        c.align.max_distance, c.parallel, c.align.one_sided);
    if (neighbors.empty()) continue;  // its last motion, or theirs, has taken it away from all others
    result.steps.push_back(PopCurrent(c, current, neighbors, queue));
  }
  result.message =
      fmt::format("{}; {} pops{}", result.message, pops,
                  queue.empty() ? "" : fmt::format(", stopped with {} scans queued", queue.size()));
  return result;
}

}  // namespace ariadne::slam
