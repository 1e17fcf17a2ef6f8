#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

namespace ariadne::slam {

using Points = std::vector<Eigen::Vector2d>;

/// Appends points from one place towards another, every `spacing` [m], both ends included.
inline void AppendLine(Points& points, const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                       double spacing = 0.05) {
  const auto steps = static_cast<int>(std::round((to - from).norm() / spacing));
  for (int i = 0; i <= steps; ++i) points.emplace_back(from + (to - from) * i / steps);
}

}  // namespace ariadne::slam
