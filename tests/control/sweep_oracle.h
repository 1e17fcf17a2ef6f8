#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "control/swept_rectangle.h"
#include "slam/base/random.h"

namespace ariadne::control {

/// The rectangle with its margin as a ring, written down once more.
inline slam::Ring RectangleRing(const RectangleOptions& robot, const slam::Pose2& T_map_robot) {
  const double front = robot.centre_ahead + 0.5 * robot.length + robot.margin;
  const double back = robot.centre_ahead - 0.5 * robot.length - robot.margin;
  const double side = 0.5 * robot.width + robot.margin;
  slam::Ring ring;
  for (const Eigen::Vector2d& p : {Eigen::Vector2d(back, -side), Eigen::Vector2d(front, -side),
                                   Eigen::Vector2d(front, side), Eigen::Vector2d(back, side)})
    ring.push_back(T_map_robot * p);
  return ring;
}

inline bool EdgesCross(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                       const Eigen::Vector2d& d) {
  const auto side = [](const Eigen::Vector2d& p, const Eigen::Vector2d& q, const Eigen::Vector2d& r) {
    return (q.x() - p.x()) * (r.y() - p.y()) - (q.y() - p.y()) * (r.x() - p.x());
  };
  return side(a, b, c) * side(a, b, d) <= 0.0 && side(c, d, a) * side(c, d, b) <= 0.0 &&
         std::max(a.x(), b.x()) >= std::min(c.x(), d.x()) &&
         std::max(c.x(), d.x()) >= std::min(a.x(), b.x()) &&
         std::max(a.y(), b.y()) >= std::min(c.y(), d.y()) &&
         std::max(c.y(), d.y()) >= std::min(a.y(), b.y());
}

/// Whether two areas have a point in common: an edge of one crosses one of the other, or one is within.
inline bool AreasMeet(const slam::Ring& a, const slam::Ring& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < b.size(); ++k) {
      if (EdgesCross(a[i], a[(i + 1) % a.size()], b[k], b[(k + 1) % b.size()])) return true;
    }
  }
  return slam::Contains({a, {}}, b[0]) || slam::Contains({b, {}}, a[0]);
}

/// Whether the rectangle hits an outline at one of the poses, or at some between, so dense that corners
/// move no more than `step` [m]. What it finds is so; what grazes it may overlook.
inline bool DenselyHits(const RectangleOptions& robot, const std::vector<slam::Pose2>& poses,
                        const std::vector<slam::Ring>& outlines, double step) {
  const double reach = std::hypot(0.5 * robot.length + robot.margin + std::abs(robot.centre_ahead),
                                  0.5 * robot.width + robot.margin);
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const slam::Pose2& to = poses[std::min(k + 1, poses.size() - 1)];
    const Eigen::Vector3d tau = (poses[k].Inverse() * to).Log();
    const int count =
        std::max(1, static_cast<int>(std::ceil((tau.head<2>().norm() + reach * std::abs(tau.z())) / step)));
    for (int i = 0; i <= count; ++i) {
      const slam::Pose2 pose = slam::Interpolate(poses[k], to, static_cast<double>(i) / count);
      const slam::Ring ring = RectangleRing(robot, pose);
      for (const slam::Ring& outline : outlines) {
        double nearest = 1e9;  // far things first, it is called a lot
        for (const Eigen::Vector2d& p : outline) nearest = std::min(nearest, (p - pose.translation).norm());
        if (nearest < reach + 3.0 && AreasMeet(ring, outline)) return true;
      }
    }
  }
  return false;
}

/// A convex outline of up to 1.2 m around a place within 2.5 m.
inline slam::Ring DrawOutline(RandomStream& stream) {
  const Eigen::Vector2d centre(DrawUniform(stream, -2.5, 2.5), DrawUniform(stream, -2.5, 2.5));
  if (DrawUniform(stream, 0.0, 1.0) < 0.5) {
    return BoxOutline({DrawUniform(stream, -M_PI, M_PI), centre}, DrawUniform(stream, 0.02, 1.0),
                      DrawUniform(stream, 0.02, 0.6));
  }
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < 6; ++i)
    points.push_back(centre +
                     0.4 * Eigen::Vector2d(DrawUniform(stream, -1, 1), DrawUniform(stream, -1, 1)));
  return ConvexOutline(points);
}

/// An arc of up to 2.5 m or half a turn, in steps that are coarse.
inline std::vector<slam::Pose2> DrawArcs(RandomStream& stream) {
  std::vector<slam::Pose2> poses{{DrawUniform(stream, -M_PI, M_PI), {0.0, 0.0}}};
  for (int arc = 0; arc < 2; ++arc) {
    const bool in_place = DrawUniform(stream, 0.0, 1.0) < 0.2;
    const double way = in_place ? 0.0 : DrawUniform(stream, -1.2, 1.2);
    const double turn = DrawUniform(stream, -1.5, 1.5);
    const int count = 1 + static_cast<int>(DrawUniform(stream, 0.0, 10.0));
    for (int i = 0; i < count; ++i)
      poses.push_back(poses.back() * slam::Pose2::Exp({way / count, 0.0, turn / count}));
  }
  return poses;
}

}  // namespace ariadne::control
