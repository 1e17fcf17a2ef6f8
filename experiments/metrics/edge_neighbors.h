#pragma once

#include <cstdint>
#include <vector>

#include "drivers/simulated/world.h"

namespace ariadne::experiments {

/// For each triangle those that share an edge with it. Vertices closer than `weld` [m] count as one,
/// because many meshes repeat them for each triangle.
std::vector<std::vector<std::uint32_t>> FindEdgeNeighbors(const drivers::TriangleMesh& mesh, double weld);

}  // namespace ariadne::experiments
