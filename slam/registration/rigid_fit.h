#pragma once

#include <Eigen/Core>

#include "slam/geometry/pose3.h"

namespace ariadne::slam {

/// What the closed-form solutions need of a set of weighted point pairs (m, d): sums over the pairs, of
/// coordinates relative to two fixed origins near the points, which keeps all digits.
struct PairMoments {
  Eigen::Matrix4d sum = Eigen::Matrix4d::Zero();  // sum w (d, 1) (m, 1)^T: rows data, columns model
  double sum_squared_distance = 0.0;              // sum w |m - (R d + t)|^2 at the present pose
  std::size_t pairs = 0;                          // pairs with w > 0

  void Add(const Eigen::Vector3d& m, const Eigen::Vector3d& d, double w, double squared_distance) {
    sum += (w * d.homogeneous()) * m.homogeneous().transpose();
    sum_squared_distance += w * squared_distance;
    ++pairs;
  }
  double weight() const { return sum(3, 3); }
  PairMoments& operator+=(const PairMoments& other);
};

/// The rigid motion that minimizes sum w |m - (R d + t)|^2.
struct RigidFit {
  Pose3 T_model_data;   // between the coordinates relative to the two origins
  bool unique = false;  // false where the pairs leave a rotation free: they lie on a line, or in a point
};

/// By Horn's unit quaternion: the eigenvector of the largest eigenvalue of the matrix N (Sec. 3.1, with the
/// signs and the order of S as in the specification's corrections 1 to 5).
RigidFit FitByQuaternion(const PairMoments& moments);

/// By the singular value decomposition of H = sum d' m'^T; the same minimum, found independently.
RigidFit FitBySvd(const PairMoments& moments);

}  // namespace ariadne::slam
