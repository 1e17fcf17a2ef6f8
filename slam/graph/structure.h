#pragma once

#include <vector>

#include "slam/graph/pose_graph.h"

namespace ariadne::slam {

/// The piece of the graph that each node belongs to, numbered from 0 in the order of their first nodes.
template <typename Pose>
std::vector<std::size_t> FindPieces(const PoseGraph<Pose>& graph);

/// Error unless the graph has nodes, is of one piece, and all of its numbers are finite.
template <typename Pose>
void CheckGraph(const PoseGraph<Pose>& graph);

/// Indices of the edges whose information matrix is not positive definite.
template <typename Pose>
std::vector<std::size_t> IndefiniteEdges(const PoseGraph<Pose>& graph);

/// Sets the poses from the fixed nodes (else the first node) along the measurements, breadth first; other
/// edges than those between successive nodes are only taken where these lead no further. For graphs whose
/// file has no vertices.
template <typename Pose>
void PlaceAlongEdges(PoseGraph<Pose>& graph);

}  // namespace ariadne::slam
