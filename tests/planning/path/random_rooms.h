#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "slam/base/random.h"
#include "slam/geometry/polygon2.h"
#include "slam/geometry/pose2.h"

namespace ariadne::planning {

inline slam::Ring Box(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

/// A room of 12 x 8 m with up to six convex pillars, turned and moved by a pose.
struct PillarRoom {
  slam::Polygon2 area;
  slam::Ring room;                  // counterclockwise
  std::vector<slam::Ring> pillars;  // counterclockwise
};

/// Corners on a circle, which makes them convex. Pillars come as near to each other as 0.3 m.
inline PillarRoom RandomPillarRoom(std::uint64_t seed) {
  RandomStream stream = NamedStream(seed, "pillar_room");
  const slam::Pose2 T_map_room{DrawUniform(stream, -3.0, 3.0),
                               {DrawUniform(stream, -50.0, 50.0), DrawUniform(stream, -50.0, 50.0)}};
  PillarRoom result;
  for (const auto& [x, y] : {std::pair{0.0, 0.0}, {12.0, 0.0}, {12.0, 8.0}, {0.0, 8.0}}) {
    result.room.push_back(T_map_room * Eigen::Vector2d(x, y));
  }
  for (int slot = 0; slot < 6; ++slot) {
    if (DrawUniform(stream, 0.0, 1.0) < 0.15) continue;
    const Eigen::Vector2d middle(2.0 + 4.0 * (slot % 3), 2.0 + 4.0 * (slot / 3));
    const double radius = DrawUniform(stream, 0.2, 1.85), start = DrawUniform(stream, 0.0, 6.28);
    const int corners = 3 + static_cast<int>(DrawUniform(stream, 0.0, 4.0));
    slam::Ring& pillar = result.pillars.emplace_back();
    for (int i = 0; i < corners; ++i) {
      const double angle = start + 2.0 * std::numbers::pi * (i + DrawUniform(stream, 0.0, 0.7)) / corners;
      pillar.push_back(T_map_room * (middle + radius * Eigen::Vector2d(std::cos(angle), std::sin(angle))));
    }
  }
  result.area.outer = result.room;
  for (const slam::Ring& pillar : result.pillars) {
    result.area.holes.emplace_back(pillar.rbegin(), pillar.rend());
  }
  return result;
}

inline double DistanceToSegment(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                                const Eigen::Vector2d& p) {
  const double square = (b - a).squaredNorm();
  const double t = square > 0.0 ? std::clamp((p - a).dot(b - a) / square, 0.0, 1.0) : 0.0;
  return (a + t * (b - a) - p).norm();
}

/// By all edges; 0 outside.
inline double TrueClearance(const slam::Polygon2& area, const Eigen::Vector2d& p) {
  if (!slam::Contains(area, p)) return 0.0;
  double nearest = std::numeric_limits<double>::infinity();
  const auto look = [&](const slam::Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      nearest = std::min(nearest, DistanceToSegment(ring[i], ring[(i + 1) % ring.size()], p));
    }
  };
  look(area.outer);
  for (const slam::Ring& hole : area.holes) look(hole);
  return nearest;
}

/// Exact: no edge of the area passes through the convex ring, and a corner lies within the area.
inline bool IsRectangleWithin(const slam::Polygon2& area, const slam::Ring& corners) {
  const auto passes = [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    double low = 0.0, high = 1.0;  // the share of the edge within all half planes
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Eigen::Vector2d along = corners[(i + 1) % corners.size()] - corners[i];
      const Eigen::Vector2d inwards(-along.y(), along.x());
      const double at_a = inwards.dot(a - corners[i]), at_b = inwards.dot(b - corners[i]);
      if (at_a <= 0.0 && at_b <= 0.0) return false;
      if (at_a < 0.0) low = std::max(low, at_a / (at_a - at_b));
      if (at_b < 0.0) high = std::min(high, at_a / (at_a - at_b));
    }
    return low < high;
  };
  const auto ring_passes = [&](const slam::Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      if (passes(ring[i], ring[(i + 1) % ring.size()])) return true;
    }
    return false;
  };
  return slam::Contains(area, corners[0]) && !ring_passes(area.outer) &&
         std::ranges::none_of(area.holes, ring_passes);
}

/// A place in the bounding box of the room and a little beyond.
inline Eigen::Vector2d DrawAround(const slam::Ring& room, RandomStream& stream) {
  Eigen::Vector2d low = room.front(), high = low;
  for (const Eigen::Vector2d& p : room) low = low.cwiseMin(p), high = high.cwiseMax(p);
  return {DrawUniform(stream, low.x() - 0.5, high.x() + 0.5),
          DrawUniform(stream, low.y() - 0.5, high.y() + 0.5)};
}

/// A place where a disc has room.
inline Eigen::Vector2d DrawFree(const PillarRoom& room, double radius, RandomStream& stream) {
  for (;;) {
    const Eigen::Vector2d p = DrawAround(room.room, stream);
    if (TrueClearance(room.area, p) >= radius) return p;
  }
}

}  // namespace ariadne::planning
