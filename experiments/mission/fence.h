#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace ariadne::experiments {

/// Places along the closed line through corners given as "x0 y0, x1 y1, ..." [m], no further apart than the
/// spacing [m]; none for an empty text. As obstacles they keep a robot inside. Error for what are no
/// corners, and for fewer than three.
std::vector<Eigen::Vector2d> FencePosts(const std::string& corners, double spacing);

}  // namespace ariadne::experiments
