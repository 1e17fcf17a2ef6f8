#include "slam/matching/match.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <numeric>

namespace ariadne::slam {
namespace {

/// What all methods share: the scans, the options, and where steps and progress go.
struct Context {
  std::vector<MapScan>& scans;
  const MatchOptions& match;
  const AlignOptions& align;
  const MatchCallback& on_progress;
  Parallel parallel;
};

bool MayMove(const AlignResult& result) {
  return result.status == AlignStatus::kConverged || result.status == AlignStatus::kDegenerate;
}

/// Aligns a scan to the union of its partners and moves it there, unless that fails.
MatchStep AlignToUnion(const Context& c, std::size_t scan, std::vector<std::size_t> partners,
                       std::size_t queued) {
  MapScan& current = c.scans[scan];
  MatchStep step;
  step.scan = scan;
  step.partners = std::move(partners);
  const auto on_iteration = [&](const AlignIteration& iteration) {
    if (c.on_progress) c.on_progress({scan, queued, &iteration});
  };
  const bool planes = c.align.metric == Metric::kPlaneToPlane;
  if (NeedsModelSurfaces(c.align)) {
    for (const std::size_t i : step.partners)
      RequireSurfaces(c.scans[i], c.align.normal_neighbors, c.parallel);
  }
  if (planes) RequireSurfaces(current, c.align.normal_neighbors, c.parallel);
  const AlignData data{current.points_laser.positions,
                       planes ? current.surfaces_laser : std::vector<SurfacePoint>{}};
  step.align = Align(UnionInMap(c.scans, step.partners), data, current.T_map_laser, c.align, on_iteration);
  step.moved_translation = TranslationDistance(current.T_map_laser, step.align.T_model_data);
  step.moved_rotation = RotationDistance(current.T_map_laser, step.align.T_model_data);
  if (MayMove(step.align)) current.T_map_laser = step.align.T_model_data;
  return step;
}

MatchResult Unmatched(std::string message) {
  MatchResult result;
  result.message = std::move(message);
  return result;
}

/// Aligns the new scan to the given partners.
MatchResult MatchOnce(const Context& c, std::vector<std::size_t> partners) {
  MatchResult result;
  result.steps.push_back(AlignToUnion(c, c.scans.size() - 1, std::move(partners), 0));
  result.registered = MayMove(result.steps.back().align);
  result.message = result.steps.back().align.message;
  c.scans.back().registered = result.registered;
  return result;
}

/// The earlier scan with the largest overlap (Sec. 3.2).
MatchResult MatchPairwise(const Context& c) {
  std::size_t best = 0, most = 0;
  for (std::size_t i = 0; i + 1 < c.scans.size(); ++i) {
    if (!c.scans[i].registered) continue;
    const std::size_t pairs = CountOverlap(c.scans[i], c.scans.back(), c.align.max_distance, c.parallel);
    if (pairs > most) {
      most = pairs;
      best = i;
    }
  }
  if (most <= static_cast<std::size_t>(c.match.overlap_pairs)) {
    return Unmatched(
        fmt::format("no earlier scan overlaps: at best {} pairs within {} m, more than {} are needed", most,
                    c.align.max_distance, c.match.overlap_pairs));
  }
  return MatchOnce(c, {best});
}

MatchResult MatchToMetascan(const Context& c) {
  std::vector<std::size_t> earlier;
  for (std::size_t i = 0; i + 1 < c.scans.size(); ++i) {
    if (c.scans[i].registered) earlier.push_back(i);
  }
  return MatchOnce(c, std::move(earlier));
}

/// One round of the queue (Sec. 3.2, step 3): aligns `current` to its neighbours, and queues them if it has
/// moved.
MatchStep PopCurrent(const Context& c, std::size_t current, const std::vector<std::size_t>& neighbors,
                     std::deque<std::size_t>& queue) {
  MatchStep step = AlignToUnion(c, current, neighbors, queue.size());
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

/// Sec. 3.2, simultaneous matching: steps 1 (pairwise start), 2 and 3 (the queue).
MatchResult MatchSimultaneously(const Context& c) {
  constexpr std::size_t kMaster = 0;  // fixed; it defines the map's coordinate system
  MatchResult result = MatchPairwise(c);
  if (!result.registered) return result;
  std::deque<std::size_t> queue{c.scans.size() - 1};
  const std::size_t max_pops = static_cast<std::size_t>(c.match.max_pops) * c.scans.size();
  std::size_t pops = 0;
  for (; !queue.empty() && pops < max_pops; ++pops) {
    const std::size_t current = queue.front();
    queue.pop_front();
    if (current == kMaster) continue;  // nothing is aligned, so nothing has moved
    const std::vector<std::size_t> neighbors =
        FindOverlapping(c.scans, current, static_cast<std::size_t>(c.match.overlap_pairs),
                        c.align.max_distance, c.parallel);
    if (neighbors.empty()) continue;  // its last motion, or theirs, has taken it away from all others
    result.steps.push_back(PopCurrent(c, current, neighbors, queue));
  }
  result.message =
      fmt::format("{}; {} pops{}", result.message, pops,
                  queue.empty() ? "" : fmt::format(", stopped with {} scans queued", queue.size()));
  return result;
}

MatchResult Dispatch(const Context& c) {
  const bool any =
      std::any_of(c.scans.begin(), c.scans.end() - 1, [](const MapScan& s) { return s.registered; });
  if (!any) return Unmatched("no scan is registered yet");
  if (c.scans.back().points_laser.empty()) return Unmatched("the scan has no points");
  switch (c.match.method) {
    case MatchMethod::kPairwise:
      return MatchPairwise(c);
    case MatchMethod::kMetascan:
      return MatchToMetascan(c);
    case MatchMethod::kSimultaneous:
      return MatchSimultaneously(c);
  }
  return {};
}

}  // namespace

MatchResult MatchNewScan(std::vector<MapScan>& scans, const MatchOptions& match, const AlignOptions& align,
                         const MatchCallback& on_progress) {
  const Pose3 T_map_laser_guess = scans.back().T_map_laser;
  MatchResult result = Dispatch({scans, match, align, on_progress, Parallel(align.threads)});
  result.T_map_laser_guess = T_map_laser_guess;
  return result;
}

}  // namespace ariadne::slam
