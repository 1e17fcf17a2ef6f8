#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "slam/base/random.h"
#include "slam/geometry/pose3.h"
#include "slam/geometry/so3.h"

/// Seeded points, directions and motions for tests.
namespace ariadne::slam {

inline Eigen::Vector3d DrawInBox(RandomStream& stream, const Eigen::Vector3d& low,
                                 const Eigen::Vector3d& high) {
  Eigen::Vector3d p;
  for (int axis = 0; axis < 3; ++axis) p[axis] = DrawUniform(stream, low[axis], high[axis]);
  return p;
}

inline Eigen::Vector3d DrawInCube(RandomStream& stream, double half_edge) {
  const Eigen::Vector3d corner = Eigen::Vector3d::Constant(half_edge);
  return DrawInBox(stream, -corner, corner);
}

inline std::vector<Eigen::Vector3d> DrawCloud(RandomStream& stream, std::size_t count, double half_edge) {
  std::vector<Eigen::Vector3d> points(count);
  for (Eigen::Vector3d& p : points) p = DrawInCube(stream, half_edge);
  return points;
}

/// Normal noise of the given sigma on each axis.
inline Eigen::Vector3d DrawNoise(RandomStream& stream, double sigma) {
  Eigen::Vector3d noise;
  for (double& x : noise) x = DrawNormal(stream, 0.0, sigma);
  return noise;
}

/// Uniform on the unit sphere.
inline Eigen::Vector3d DrawDirection(RandomStream& stream) { return DrawNoise(stream, 1.0).normalized(); }

/// Uniform in a ball.
inline Eigen::Vector3d DrawInBall(RandomStream& stream, double radius) {
  const Eigen::Vector3d direction = DrawDirection(stream);
  return radius * std::cbrt(DrawUniform(stream, 0.0, 1.0)) * direction;
}

/// A motion of at most the given distance [m] and angle [rad].
inline Pose3 DrawMotion(RandomStream& stream, double max_distance, double max_angle) {
  const Eigen::Vector3d rotation = DrawInBall(stream, max_angle);
  return {ExpSo3(rotation), DrawInBall(stream, max_distance)};
}

inline Eigen::Vector3d CentroidOf(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : points) sum += p;
  return sum / static_cast<double>(points.size());
}

/// The motion as seen about a point: it turns about `center` and then moves it.
inline Pose3 AboutPoint(const Eigen::Vector3d& center, const Pose3& motion) {
  return {motion.rotation, motion.translation + center - motion.rotation * center};
}

}  // namespace ariadne::slam
