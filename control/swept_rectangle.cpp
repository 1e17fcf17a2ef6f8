#include "control/swept_rectangle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace ariadne::control {
namespace {

using Eigen::Vector2d;
using slam::Pose2;
using slam::Ring;

Vector2d HalfSize(const RectangleOptions& robot) {
  return {0.5 * robot.length + robot.margin, 0.5 * robot.width + robot.margin};
}

/// In the frame of the rectangle's centre.
Vector2d FromCentre(const RectangleOptions& robot, const Pose2& T_map_robot, const Vector2d& p_map) {
  return T_map_robot.RotationMatrix().transpose() * (p_map - T_map_robot.translation) -
         Vector2d(robot.centre_ahead, 0.0);
}

double Cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Along the normals of the outline's own edges.
double GapAlongEdges(const Vector2d& half, const Ring& outline) {
  double gap = -std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Vector2d edge = outline[(k + 1) % outline.size()] - outline[k];
    const double length = edge.norm();
    if (length < 1e-12) continue;
    const Vector2d normal = Vector2d(edge.y(), -edge.x()) / length;
    const double rectangle = half.dot(normal.cwiseAbs());
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Vector2d& p : outline) {
      low = std::min(low, normal.dot(p));
      high = std::max(high, normal.dot(p));
    }
    gap = std::max({gap, low - rectangle, -high - rectangle});
  }
  return gap;
}

/// Halves an arc until it is clear, or too short to look closer.
template <typename Gap>
class ArcSearch {
 public:
  ArcSearch(const RectangleOptions& robot, const Pose2& from, const Pose2& to, const Gap& gap)
      : from_(from),
        tau_((from.Inverse() * to).Log()),
        half_sweep_(HalfSweep(robot, from, to)),
        tolerance_(robot.tolerance),
        gap_(gap) {}

  std::optional<double> First(double low, double high) const {
    const double middle = 0.5 * (low + high);
    const double moves = half_sweep_ * (high - low);
    const double gap = gap_(from_ * Pose2::Exp(middle * tau_));
    if (gap > moves) return {};
    if (moves < 0.5 * tolerance_) return low;
    if (const auto first = First(low, middle)) return first;
    return First(middle, high);
  }

 private:
  const Pose2& from_;
  Pose2::Tangent tau_;
  double half_sweep_, tolerance_;
  const Gap& gap_;
};

template <typename Gap>
std::optional<double> FirstOnArc(const RectangleOptions& robot, const Pose2& from, const Pose2& to,
                                 const Gap& gap) {
  return ArcSearch<Gap>(robot, from, to, gap).First(0.0, 1.0);
}

/// ArcSearch for many points at once: in each half of an arc only those are looked at that are near it.
class PointSearch {
 public:
  PointSearch(const RectangleOptions& robot, const Pose2& from, const Pose2& to,
              const std::vector<Vector2d>& points)
      : robot_(robot),
        from_(from),
        tau_((from.Inverse() * to).Log()),
        half_sweep_(HalfSweep(robot, from, to)),
        points_(points) {}

  std::optional<PointTouch> First() const {
    std::vector<std::size_t> all(points_.size());
    std::iota(all.begin(), all.end(), 0);
    return First(0.0, 1.0, all);
  }

 private:
  std::optional<PointTouch> First(double low, double high, const std::vector<std::size_t>& some) const {
    const double middle = 0.5 * (low + high);
    const double moves = half_sweep_ * (high - low);
    const Pose2 pose = from_ * Pose2::Exp(middle * tau_);
    const Eigen::Matrix2d R_robot_map = pose.RotationMatrix().transpose();
    const Vector2d centre = pose * Vector2d(robot_.centre_ahead, 0.0);
    const Vector2d half = HalfSize(robot_);
    std::vector<std::size_t> near;
    double nearest = std::numeric_limits<double>::infinity();
    std::size_t nearest_point = 0;
    for (const std::size_t i : some) {
      const Vector2d p = R_robot_map * (points_[i] - centre);
      const double gap = (p.cwiseAbs() - half).maxCoeff();
      if (gap > moves) continue;
      near.push_back(i);
      if (gap < nearest) nearest = gap, nearest_point = i;
    }
    if (near.empty()) return {};
    if (moves < 0.5 * robot_.tolerance) return PointTouch{low, nearest_point};
    if (const auto first = First(low, middle, near)) return first;
    return First(middle, high, near);
  }

  const RectangleOptions& robot_;
  const Pose2& from_;
  Pose2::Tangent tau_;
  double half_sweep_;
  const std::vector<Vector2d>& points_;
};

void RequireConvex(const Ring& outline) {
  double left = 0.0, right = 0.0, turn = 0.0;
  const std::size_t n = outline.size();
  if (n == 0) Fail("an outline of an obstacle has no corner");
  for (std::size_t k = 0; k < n; ++k) {
    if (!outline[k].allFinite()) Fail("corner {} of an obstacle's outline is not finite", k);
    const Vector2d a = outline[(k + 1) % n] - outline[k];
    const Vector2d b = outline[(k + 2) % n] - outline[(k + 1) % n];
    const double cross = Cross(a, b);
    left = std::max(left, cross), right = std::max(right, -cross);
    if (n > 2 && a.norm() * b.norm() > 0.0) turn += std::atan2(cross, a.dot(b));
  }
  // Corners on one line may be off by rounding; a star turns more than once.
  if (std::min(left, right) > 1e-9 || std::abs(turn) > 7.0)
    Fail("the outline of an obstacle around ({}, {}) is not convex", outline[0].x(), outline[0].y());
}

void RequireSweep(const RectangleOptions& robot, const std::vector<Pose2>& poses,
                  const GroundObstacles& obstacles) {
  CheckOptions(robot, "robot.");
  std::ranges::for_each(obstacles.outlines, RequireConvex);
  const auto is_finite = [](const Vector2d& p) { return p.allFinite(); };
  if (!std::ranges::all_of(obstacles.points, is_finite)) Fail("an obstacle's point is not finite");
  for (const Pose2& pose : poses) {
    if (!std::isfinite(pose.angle) || !pose.translation.allFinite())
      Fail("a pose of the trajectory is not finite");
  }
}

}  // namespace

Ring BoxOutline(const Pose2& T_map_box, double length, double width) {
  const Vector2d along(0.5 * length, 0.0), across(0.0, 0.5 * width);
  return {T_map_box * (-along - across), T_map_box * (along - across), T_map_box * (along + across),
          T_map_box * (across - along)};
}

Ring ConvexOutline(std::vector<Vector2d> points) {
  std::ranges::sort(points, [](const Vector2d& a, const Vector2d& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  Ring outline;  // Andrew's monotone chain: below from left to right, then above, back
  for (const int pass : {0, 1}) {
    const std::size_t base = outline.size();
    for (const Vector2d& p : points) {
      while (outline.size() >= base + 2 &&
             Cross(outline.back() - outline[outline.size() - 2], p - outline.back()) <= 0.0)
        outline.pop_back();
      outline.push_back(p);
    }
    outline.pop_back();
    if (pass == 0) std::ranges::reverse(points);
  }
  return outline;
}

double GapTo(const RectangleOptions& robot, const Pose2& T_map_robot, const Vector2d& p_map) {
  return PlacedRectangle(robot, T_map_robot).GapTo(p_map);
}

PlacedRectangle::PlacedRectangle(const RectangleOptions& robot, const Pose2& T_map_robot)
    : R_robot_map_(T_map_robot.RotationMatrix().transpose()),
      p_map_robot_(T_map_robot.translation),
      p_robot_centre_(robot.centre_ahead, 0.0),
      half_(HalfSize(robot)) {}

double PlacedRectangle::GapTo(const Vector2d& p_map) const {
  const Vector2d from_centre = R_robot_map_ * (p_map - p_map_robot_) - p_robot_centre_;
  return (from_centre.cwiseAbs() - half_).maxCoeff();
}

double GapTo(const RectangleOptions& robot, const Pose2& T_map_robot, const Ring& outline) {
  const Vector2d half = HalfSize(robot);
  Vector2d low = Vector2d::Constant(std::numeric_limits<double>::infinity()), high = -low;
  Ring seen;
  seen.reserve(outline.size());
  for (const Vector2d& p_map : outline) {
    seen.push_back(FromCentre(robot, T_map_robot, p_map));
    low = low.cwiseMin(seen.back());
    high = high.cwiseMax(seen.back());
  }
  const double gap = (low - half).cwiseMax(-high - half).maxCoeff();
  return std::max(gap, GapAlongEdges(half, seen));
}

double HalfSweep(const RectangleOptions& robot, const Pose2& from, const Pose2& to) {
  const Pose2::Tangent tau = (from.Inverse() * to).Log();
  const Vector2d half = HalfSize(robot);
  double farthest = 0.0;
  for (const double x : {robot.centre_ahead - half.x(), robot.centre_ahead + half.x()}) {
    for (const double y : {-half.y(), half.y()})
      farthest = std::max(farthest, std::hypot(tau.x() - tau.z() * y, tau.y() + tau.z() * x));
  }
  return 0.5 * farthest;
}

std::optional<SweepHit> FirstHit(const RectangleOptions& robot, const std::vector<Pose2>& poses,
                                 const GroundObstacles& obstacles) {
  RequireSweep(robot, poses, obstacles);
  std::optional<SweepHit> hit;
  for (std::size_t k = 0; k < poses.size() && !hit; ++k) {
    const Pose2& to = poses[std::min(k + 1, poses.size() - 1)];
    const double sweep = 2.0 * HalfSweep(robot, poses[k], to);
    for (std::size_t i = 0; i < obstacles.outlines.size(); ++i) {
      const auto gap = [&](const Pose2& pose) { return GapTo(robot, pose, obstacles.outlines[i]); };
      if (gap(poses[k]) > sweep) continue;  // most are far
      const std::optional<double> share = FirstOnArc(robot, poses[k], to, gap);
      if (share && (!hit || *share < hit->share)) hit = SweepHit{k, *share, {}, i};
    }
    const std::optional<PointTouch> touch = FirstTouch(robot, poses[k], to, obstacles.points);
    if (touch && (!hit || touch->share < hit->share))
      hit = SweepHit{k, touch->share, {}, obstacles.outlines.size() + touch->point};
    if (hit) hit->T_map_robot = Interpolate(poses[k], to, hit->share);
  }
  return hit;
}

std::optional<PointTouch> FirstTouch(const RectangleOptions& robot, const Pose2& from, const Pose2& to,
                                     const std::vector<Vector2d>& points) {
  return PointSearch(robot, from, to, points).First();
}

}  // namespace ariadne::control
