#include "drivers/simulated/solids.h"

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "slam/base/error.h"

namespace ariadne::drivers {
namespace {

using Index = std::uint32_t;
using Eigen::Vector3d;

Index Count(const TriangleMesh& mesh) { return static_cast<Index>(mesh.vertices.size()); }

void AddQuad(TriangleMesh& mesh, Index a, Index b, Index c, Index d) {
  mesh.triangles.push_back({a, b, c});
  mesh.triangles.push_back({a, c, d});
}

/// Adds the corners of one profile point: a circle, or the one point on the axis. Returns the first index.
Index AddRing(TriangleMesh& mesh, const ProfilePoint& p, int sides) {
  const Index first = Count(mesh);
  if (p.x() <= 0.0) {
    mesh.vertices.push_back({0.0, 0.0, p.y()});
    return first;
  }
  for (int i = 0; i < sides; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / sides;
    mesh.vertices.push_back({p.x() * std::cos(angle), p.x() * std::sin(angle), p.y()});
  }
  return first;
}

}  // namespace

TriangleMesh MakeBox(const slam::Box3& box) {
  const Vector3d& low = box.min();
  const Vector3d& high = box.max();
  return MakePrism({{low.x(), low.y()}, {high.x(), low.y()}, {high.x(), high.y()}, {low.x(), high.y()}},
                   low.z(), high.z());
}

TriangleMesh MakePrism(const std::vector<Eigen::Vector2d>& outline, double bottom, double top) {
  if (!(bottom < top)) Fail("a prism from z = {} m to {} m has no volume", bottom, top);
  TriangleMesh mesh;
  double area = 0.0;
  const Index n = static_cast<Index>(outline.size());
  for (Index i = 0; i < n; ++i) {
    const Eigen::Vector2d &p = outline[i], &q = outline[(i + 1) % n];
    area += p.x() * q.y() - p.y() * q.x();
    mesh.vertices.push_back({p.x(), p.y(), bottom});
  }
  for (const Eigen::Vector2d& p : outline) mesh.vertices.push_back({p.x(), p.y(), top});
  for (const auto& [a, b, c] : Triangulate(outline)) {
    mesh.triangles.push_back({c, b, a});
    mesh.triangles.push_back({n + a, n + b, n + c});
  }
  for (Index i = 0; i < n; ++i) {
    const Index here = area > 0.0 ? i : (i + 1) % n, there = area > 0.0 ? (i + 1) % n : i;
    AddQuad(mesh, here, there, n + there, n + here);
  }
  return mesh;
}

TriangleMesh MakeRevolved(const std::vector<ProfilePoint>& profile, int sides) {
  if (profile.size() < 3 || profile.front().x() > 0.0 || profile.back().x() > 0.0) {
    Fail("the profile of a revolved solid needs three points, the first and the last on the axis");
  }
  TriangleMesh mesh;
  const Index n = static_cast<Index>(sides);
  Index lower = AddRing(mesh, profile[0], sides);
  for (std::size_t k = 1; k < profile.size(); ++k) {
    const Index upper = AddRing(mesh, profile[k], sides);
    const bool from_axis = profile[k - 1].x() <= 0.0, to_axis = profile[k].x() <= 0.0;
    for (Index i = 0; i < n && !(from_axis && to_axis); ++i) {
      const Index j = (i + 1) % n;
      if (from_axis) {
        mesh.triangles.push_back({lower, upper + j, upper + i});
      } else if (to_axis) {
        mesh.triangles.push_back({lower + i, lower + j, upper});
      } else {
        AddQuad(mesh, lower + i, lower + j, upper + j, upper + i);
      }
    }
    lower = upper;
  }
  return mesh;
}

TriangleMesh MakeCylinder(double radius, double height, int sides) {
  return MakeRevolved({{0.0, 0.0}, {radius, 0.0}, {radius, height}, {0.0, height}}, sides);
}

TriangleMesh MakeEllipsoid(const Vector3d& center, const Vector3d& radii, int sides) {
  const int rings = std::max(2, sides / 2);
  std::vector<ProfilePoint> profile{{0.0, -1.0}};
  for (int k = 1; k < rings; ++k) {
    const double angle = std::numbers::pi * (static_cast<double>(k) / rings - 0.5);
    profile.push_back({std::cos(angle), std::sin(angle)});
  }
  profile.push_back({0.0, 1.0});
  TriangleMesh mesh = MakeRevolved(profile, sides);
  for (Vector3d& v : mesh.vertices) v = center + v.cwiseProduct(radii);
  return mesh;
}

TriangleMesh MakeRod(const Vector3d& from, const Vector3d& to, double radius_from, double radius_to,
                     int sides) {
  const double length = (to - from).norm();
  const auto turn = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), to - from);
  return Moved(MakeRevolved({{0.0, 0.0}, {radius_from, 0.0}, {radius_to, length}, {0.0, length}}, sides),
               {turn, from});
}

TriangleMesh Moved(TriangleMesh mesh, const slam::Pose3& T_to_from) {
  for (Vector3d& v : mesh.vertices) v = T_to_from * v;
  return mesh;
}

bool IsClosed(const TriangleMesh& mesh) {
  std::map<std::pair<Index, Index>, int> edges;  // how often each runs forward, less how often back
  for (const auto& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Index a = t[i], b = t[(i + 1) % 3];
      edges[std::minmax(a, b)] += a < b ? 1 : -1;
    }
  }
  for (const auto& [edge, balance] : edges) {
    if (balance != 0) return false;
  }
  return !mesh.triangles.empty();
}

double Volume(const TriangleMesh& mesh) {
  double sum = 0.0;
  const Vector3d origin = mesh.vertices.empty() ? Vector3d::Zero() : mesh.vertices.front();
  for (const auto& [a, b, c] : mesh.triangles) {
    sum += (mesh.vertices[a] - origin).dot((mesh.vertices[b] - origin).cross(mesh.vertices[c] - origin));
  }
  return sum / 6.0;
}

}  // namespace ariadne::drivers
