#pragma once

#include <vector>

#include "slam/map/horizontal_slice.h"

namespace ariadne::planning {

/// Where the surfaces between two neighbouring rows of a scan pass the height of a slice: beams of one
/// bearing within their rows whose points lie on either side of it, both outside of the slice, and whose
/// ranges differ by less than `max_jump` [m], so that they are on one surface. In the map frame [m]; none
/// for clouds whose rows are not known. Error where a coordinate or the pose is NaN or infinite.
std::vector<Eigen::Vector2d> RowCrossings(const slam::PosedCloud& scan,
                                          const slam::HorizontalSliceOptions& slice, double max_jump);

}  // namespace ariadne::planning
