#pragma once

#include <filesystem>

#include "slam/map/occupancy_grid.h"

namespace ariadne::slam {

/// Writes a grid as ROS's map_server and nav2 read it: an image (binary PGM, the top row first; 0 occupied,
/// 254 free, 205 unknown), and a YAML file of the same name beside it with resolution, origin and
/// thresholds. `path` ends in .pgm. Error for another extension, a grid without cells, or where a file
/// cannot be written.
void WriteOccupancyGrid(const std::filesystem::path& path, const OccupancyGrid& grid);

}  // namespace ariadne::slam
