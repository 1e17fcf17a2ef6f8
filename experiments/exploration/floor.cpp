#include "experiments/exploration/floor.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

constexpr double kOffGrid = 1e-6;  // the cut passes no vertex: models have theirs at round heights [m]
constexpr double kSamePlace = 1e-6;
constexpr double kInLine = 1e-6;
constexpr double kOnSide = 1e-3;     // [m]
constexpr double kUpright = 0.0872;  // sin of what the docstring promises

std::optional<FloorWall> CutTriangle(const std::array<Eigen::Vector3d, 3>& p, double z) {
  std::array<Eigen::Vector2d, 3> ends;
  std::size_t count = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector3d& a = p[i];
    const Eigen::Vector3d& b = p[(i + 1) % 3];
    if ((a.z() < z) == (b.z() < z)) continue;
    ends[count++] = (a + (z - a.z()) / (b.z() - a.z()) * (b - a)).head<2>();
  }
  if (count != 2 || (ends[0] - ends[1]).norm() < kSamePlace) return {};
  const Eigen::Vector3d normal = (p[1] - p[0]).cross(p[2] - p[0]).normalized();
  return FloorWall{ends[0], ends[1], std::abs(normal.z()) <= kUpright};
}

using Cell = std::pair<long, long>;

Cell CellOf(const Eigen::Vector2d& p) { return {std::lround(p.x() / 1e-4), std::lround(p.y() / 1e-4)}; }

/// The end of `face` that is not at `p`.
Eigen::Vector2d OtherEnd(const FloorWall& face, const Eigen::Vector2d& p) {
  return (face.from - p).norm() < (face.to - p).norm() ? face.to : face.from;
}

/// Joins two faces of one body that meet in line, as the two triangles of a rectangle do.
void JoinInLine(std::vector<FloorWall>& faces) {
  std::map<Cell, std::vector<std::size_t>> at;
  std::vector<bool> gone(faces.size(), false);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    for (const Eigen::Vector2d& end : {faces[i].from, faces[i].to}) at[CellOf(end)].push_back(i);
  }
  for (std::size_t i = 0; i < faces.size(); ++i) {
    for (bool grown = !gone[i]; grown;) {
      grown = false;
      for (const Eigen::Vector2d& end : {faces[i].from, faces[i].to}) {
        for (const std::size_t k : at[CellOf(end)]) {
          if (k == i || gone[k] || faces[k].upright != faces[i].upright) continue;
          const Eigen::Vector2d near = OtherEnd(faces[i], end), far = OtherEnd(faces[k], end);
          const Eigen::Vector2d a = (end - near).normalized(), b = (far - end).normalized();
          if (a.dot(b) < 0.0 || std::abs(a.x() * b.y() - a.y() * b.x()) > kInLine) continue;
          faces[i] = {near, far, faces[i].upright};
          at[CellOf(far)].push_back(i);
          gone[k] = grown = true;
          break;
        }
        if (grown) break;
      }
    }
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (!gone[i]) faces[kept++] = faces[i];
  }
  faces.resize(kept);
}

/// The share of one side of a box that faces lie along: the least or the greatest x or y.
double WalledShare(const std::vector<FloorWall>& faces, const Eigen::AlignedBox2d& box, int axis,
                   bool least) {
  const double at = least ? box.min()[axis] : box.max()[axis];
  const int along = 1 - axis;
  std::vector<std::pair<double, double>> walled;
  for (const FloorWall& face : faces) {
    if (std::abs(face.from[axis] - at) > kOnSide || std::abs(face.to[axis] - at) > kOnSide) continue;
    walled.push_back(std::minmax({face.from[along], face.to[along]}));
  }
  std::ranges::sort(walled);
  double length = 0.0, done = box.min()[along];
  for (const auto& [from, to] : walled) {
    length += std::max(0.0, to - std::max(from, done));
    done = std::max(done, to);
  }
  return length / box.sizes()[along];
}

bool IsEnclosed(const std::vector<FloorWall>& faces) {
  Eigen::AlignedBox2d box;
  for (const FloorWall& face : faces) box.extend(face.from).extend(face.to);
  const auto is_walled = [&](int axis, bool least) { return WalledShare(faces, box, axis, least) > 0.999; };
  return is_walled(0, true) && is_walled(0, false) && is_walled(1, true) && is_walled(1, false);
}

}  // namespace

Floor CutFloor(const drivers::World& world, double height) {
  Floor floor{world.name, {}, world.T_map_start};
  for (const drivers::Body& body : world.bodies) {
    if (body.motion.moves()) continue;
    const drivers::TriangleMesh mesh = drivers::MeshAt(body, 0.0);
    std::vector<FloorWall> faces;
    for (const auto& triangle : mesh.triangles) {
      const auto face = CutTriangle({mesh.vertices[static_cast<std::size_t>(triangle[0])],
                                     mesh.vertices[static_cast<std::size_t>(triangle[1])],
                                     mesh.vertices[static_cast<std::size_t>(triangle[2])]},
                                    height + kOffGrid);
      if (face) faces.push_back(*face);
    }
    JoinInLine(faces);
    floor.faces.insert(floor.faces.end(), faces.begin(), faces.end());
  }
  if (floor.faces.empty()) Fail("{}: nothing stands at a height of {} m", world.name, height);
  floor.enclosed = IsEnclosed(floor.faces);
  return floor;
}

}  // namespace ariadne::experiments
