#include "slam/matching/match_context.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace ariadne::slam {

bool MayMove(const AlignResult& result) {
  return result.status == AlignStatus::kConverged || result.status == AlignStatus::kDegenerate;
}

MatchStep AlignToUnion(const MatchContext& c, std::size_t scan, std::vector<std::size_t> partners,
                       std::size_t queued, const AlignOptions& align) {
  MapScan& current = c.map.scans[scan];
  MatchStep step;
  step.scan = scan;
  step.partners = std::move(partners);
  const auto on_iteration = [&](const AlignIteration& iteration) {
    if (c.on_progress) c.on_progress({scan, queued, &iteration});
  };
  if (NeedsModelSurfaces(align)) {
    for (const std::size_t i : step.partners)
      RequireSurfaces(c.map.scans[i], align.normal_neighbors, c.parallel);
  }
  if (NeedsDataSurfaces(align)) RequireSurfaces(current, align.normal_neighbors, c.parallel);
  const AlignData data{current.points_laser.positions,
                       NeedsDataSurfaces(align) ? current.surfaces_laser : std::vector<SurfacePoint>{}};
  step.align =
      Align(UnionInMap(c.map.scans, step.partners), data, current.T_map_laser, align, on_iteration);
  step.moved_translation = TranslationDistance(current.T_map_laser, step.align.T_model_data);
  step.moved_rotation = RotationDistance(current.T_map_laser, step.align.T_model_data);
  return step;
}

MatchStep MoveToUnion(const MatchContext& c, std::size_t scan, std::vector<std::size_t> partners,
                      std::size_t queued) {
  MatchStep step = AlignToUnion(c, scan, std::move(partners), queued, c.align);
  if (MayMove(step.align)) c.map.scans[scan].T_map_laser = step.align.T_model_data;
  return step;
}

void MoveInPass(MapScan& scan, const Pose3& T_map_laser, MatchPass& pass) {
  pass.moved_translation =
      std::max(pass.moved_translation, TranslationDistance(scan.T_map_laser, T_map_laser));
  pass.moved_rotation = std::max(pass.moved_rotation, RotationDistance(scan.T_map_laser, T_map_laser));
  scan.T_map_laser = T_map_laser;
}

MatchResult Unmatched(std::string message) {
  MatchResult result;
  result.message = std::move(message);
  return result;
}

MatchResult MatchOnce(const MatchContext& c, std::vector<std::size_t> partners) {
  MatchResult result;
  result.steps.push_back(MoveToUnion(c, c.map.scans.size() - 1, std::move(partners), 0));
  result.registered = MayMove(result.steps.back().align);
  result.message = result.steps.back().align.message;
  c.map.scans.back().registered = result.registered;
  return result;
}

std::vector<Overlap> FindOverlaps(const MatchContext& c) {
  const std::vector<MapScan>& scans = c.map.scans;
  std::vector<Overlap> overlaps;
  for (std::size_t i = 0; i + 1 < scans.size(); ++i) {
    if (!scans[i].registered) continue;
    const std::size_t pairs =
        CountOverlap(scans[i], scans.back(), c.align.max_distance, c.parallel, c.align.one_sided);
    if (pairs > 0) overlaps.push_back({i, pairs});
  }
  std::ranges::stable_sort(overlaps, std::greater{}, &Overlap::pairs);
  return overlaps;
}

bool IsEnough(const MatchContext& c, const Overlap& overlap) {
  return overlap.pairs > static_cast<std::size_t>(c.match.overlap_pairs);
}

MatchResult WithoutOverlap(const MatchContext& c, const std::vector<Overlap>& overlaps) {
  return Unmatched(fmt::format(
      "no earlier scan overlaps: at best {} pairs within {} m, more than {} are needed",
      overlaps.empty() ? 0 : overlaps.front().pairs, c.align.max_distance, c.match.overlap_pairs));
}

MatchResult MatchPairwise(const MatchContext& c) {
  const std::vector<Overlap> overlaps = FindOverlaps(c);
  if (overlaps.empty() || !IsEnough(c, overlaps.front())) return WithoutOverlap(c, overlaps);
  return MatchOnce(c, {overlaps.front().scan});
}

MatchResult MatchToOverlapping(const MatchContext& c) {
  const std::vector<Overlap> overlaps = FindOverlaps(c);
  std::vector<std::size_t> partners;
  for (const Overlap& overlap : overlaps) {
    if (partners.size() == static_cast<std::size_t>(c.match.graph.start_partners)) break;
    if (IsEnough(c, overlap)) partners.push_back(overlap.scan);
  }
  if (partners.empty()) return WithoutOverlap(c, overlaps);
  AlignOptions align = c.align;
  align.shrink *= align.shrink;  // down to the gate in half the steps: what follows goes on from there
  align.convergence_step = std::max(align.convergence_step, c.match.graph.start_step);
  return MatchOnce({c.map, c.match, align, c.on_progress, Parallel(align.threads)}, std::move(partners));
}

}  // namespace ariadne::slam
