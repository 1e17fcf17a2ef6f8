#pragma once

#include <optional>
#include <string>
#include <vector>

#include "slam/registration/align.h"
#include "slam/registration/correspondences.h"
#include "slam/scan/point_cloud.h"

namespace ariadne::slam {

/// A scan of the map under construction.
struct MapScan {
  std::string name;
  PointCloud points_laser;  // reduced
  KdTree tree_laser;        // of these points
  Pose3 T_map_laser;
  bool registered = false;  // false: T_map_laser is a guess, and no other scan may be matched to it
  std::vector<SurfacePoint> surfaces_laser = {};       // one per point, once an alignment has needed them
  std::optional<Pose3::Square> guess_covariance = {};  // of its first pose to the scan before, if known
};

/// Estimates the surfaces of a scan, unless that has been done.
void RequireSurfaces(MapScan& scan, int neighbors, const Parallel& parallel);

/// How many points of `data` have been paired; with `one_sided`, with points that were seen from the same
/// side as theirs (the scans have surfaces then).
std::size_t CountPairs(const Correspondences& pairs, const MapScan& model, const MapScan& data,
                       const Pose3& T_model_data, bool one_sided);

/// How many points of `data` have a point of `model` closer than max_distance [m], at the scans' poses.
/// This is what the paper calls the overlap (Sec. 3.2). `one_sided` as in CountPairs().
std::size_t CountOverlap(const MapScan& model, const MapScan& data, double max_distance,
                         const Parallel& parallel, bool one_sided = false);

/// The registered scans, other than `current`, with more than min_pairs pairs.
std::vector<std::size_t> FindOverlapping(const std::vector<MapScan>& scans, std::size_t current,
                                         std::size_t min_pairs, double max_distance,
                                         const Parallel& parallel, bool one_sided = false);

/// The points of several scans in map coordinates, with the surfaces that each scan has found by itself
/// (scans that lie not yet on each other would spoil common ones): the set M that a scan is aligned to.
AlignModel UnionInMap(const std::vector<MapScan>& scans, const std::vector<std::size_t>& members);

}  // namespace ariadne::slam
