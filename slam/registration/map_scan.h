#pragma once

#include <string>
#include <vector>

#include "slam/registration/align.h"
#include "slam/scan/point_cloud.h"

namespace ariadne::slam {

/// A scan of the map under construction.
struct MapScan {
  std::string name;
  PointCloud points_laser;  // reduced
  KdTree tree_laser;        // of these points
  Pose3 T_map_laser;
  bool registered = false;  // false: T_map_laser is a guess, and no other scan may be matched to it
};

/// How many points of `data` have a point of `model` closer than max_distance [m], at the scans' poses.
/// This is what the paper calls the overlap (Sec. 3.2).
std::size_t CountOverlap(const MapScan& model, const MapScan& data, double max_distance,
                         const Parallel& parallel);

/// The registered scans, other than `current`, with more than min_pairs pairs.
std::vector<std::size_t> FindOverlapping(const std::vector<MapScan>& scans, std::size_t current,
                                         std::size_t min_pairs, double max_distance,
                                         const Parallel& parallel);

/// The points of several scans in map coordinates: the set M that a scan is aligned to.
PointCloud UnionInMap(const std::vector<MapScan>& scans, const std::vector<std::size_t>& members);

}  // namespace ariadne::slam
