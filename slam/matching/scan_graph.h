#pragma once

#include <vector>

#include "slam/graph/pose_graph.h"
#include "slam/matching/map_scan.h"
#include "slam/matching/match_options.h"

namespace ariadne::slam {

/// From what an edge between two scans was made.
enum class ScanEdgeKind { kOdometry, kAlignment, kClosure };

/// What is known of how the scans lie to each other: node i is scan i, whose pose is that of the scan.
struct ScanGraph {
  PoseGraph3 graph;
  std::vector<ScanEdgeKind> kinds;  // of the edges
};

/// The scans of a map, and what the methods graph and joint know of them beside their poses.
struct ScanMap {
  std::vector<MapScan> scans;  // the first is the master
  ScanGraph graph;             // without nodes for the other methods
};

/// Gives each scan that has none a node, held to that of the scan before by where the odometry has seen it,
/// which is where it is now; as tightly as its guess_covariance says, or else the options.
void AddMissingNodes(ScanMap& map, const ScanGraphOptions& options);

/// Adds what an alignment of the scan `to` to the scan `from` alone has found.
void AddAlignment(ScanMap& map, std::size_t from, std::size_t to, const AlignResult& align,
                  const ScanGraphOptions& options, ScanEdgeKind kind);

/// The inverse of the covariance of a converged alignment of this cloud, without that of directions in
/// which the surfaces do not hold it: there it knows nothing.
Pose3::Square InformationOf(const AlignResult& align, const PointCloud& data,
                            const ScanGraphOptions& options);

/// Whether an edge of another kind than odometry joins the two scans.
bool AreJoined(const ScanGraph& graph, std::size_t a, std::size_t b);

}  // namespace ariadne::slam

namespace ariadne {

template <>
struct EnumNames<slam::ScanEdgeKind> {
  static constexpr std::array<std::string_view, 3> value{"odometry", "alignment", "closure"};
};

}  // namespace ariadne
