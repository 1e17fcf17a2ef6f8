#pragma once

#include <string>
#include <vector>

#include "slam/geometry/pose3.h"

namespace ariadne::slam {

/// Which motions of the data the paired surfaces would notice. Sliding along a corridor, or turning inside
/// a round tower, changes no distance to a surface, whatever the metric; a point-to-point error alone does
/// not reveal that.
///
/// The eigenvalues are those of the mean of j j^T over the pairs, j = (n, (d - c) x n / length): the
/// derivative of the distance to the model's tangent plane by a motion of the data about its centroid c,
/// with rotations made comparable by the data's root mean square distance from c. The three translational
/// and three rotational shares each sum up to at most one.
struct Observability {
  Pose3::Tangent shares = Pose3::Tangent::Zero();  // eigenvalues, ascending
  Pose3::Square directions =
      Pose3::Square::Identity();  // eigenvectors in columns; data frame, about c; m, rad
  int degenerate = 0;             // how many of the first directions are not observed

  /// For a message: "moves along (1.00, 0.01, 0.00)", "turns about (0.00, 0.00, 1.00)"; empty if none.
  std::string DescribeDegenerate() const;
};

/// From the sum of j j^T over `count` pairs; directions with a smaller share than min_share are degenerate.
Observability ObserveMotions(const Pose3::Square& sum, std::size_t count, double min_share);

}  // namespace ariadne::slam
