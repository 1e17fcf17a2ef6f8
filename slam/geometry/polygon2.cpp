#include "slam/geometry/polygon2.h"

#include <cmath>
#include <polyclipping/clipper.hpp>

#include "slam/base/error.h"

namespace ariadne::slam {
namespace {

namespace cl = ClipperLib;

constexpr double kCornersPerMeter = 1e4;  // what the docstring promises: 0.1 mm
constexpr double kMaxCoordinate = 1e8;    // far beyond any building, far within 64 bits [m]

double Length(const Ring& ring) {
  double length = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) length += (ring[(i + 1) % ring.size()] - ring[i]).norm();
  return length;
}

/// Whether a ray from p to the right meets the ring an odd number of times.
bool Encloses(const Ring& ring, const Eigen::Vector2d& p) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Eigen::Vector2d& a = ring[i];
    const Eigen::Vector2d& b = ring[(i + 1) % ring.size()];
    if ((a.y() > p.y()) == (b.y() > p.y())) continue;
    if (p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
  }
  return inside;
}

cl::Path ToPath(const Ring& ring) {
  cl::Path path;
  path.reserve(ring.size());
  for (const Eigen::Vector2d& p : ring) {
    if (!p.allFinite() || p.cwiseAbs().maxCoeff() >= kMaxCoordinate) {
      Fail("a polygon has the corner ({}, {}), which is no place within {} m", p.x(), p.y(),
           kMaxCoordinate);
    }
    path.emplace_back(std::llround(p.x() * kCornersPerMeter), std::llround(p.y() * kCornersPerMeter));
  }
  return path;
}

Ring ToRing(const cl::Path& path) {
  Ring ring;
  ring.reserve(path.size());
  for (const cl::IntPoint& p : path) {
    ring.emplace_back(static_cast<double>(p.X) / kCornersPerMeter,
                      static_cast<double>(p.Y) / kCornersPerMeter);
  }
  return ring;
}

/// What the outer ring encloses without what the holes enclose: outer boundaries run counterclockwise and
/// those of holes clockwise, so that their windings add up to 1 within the area and to 0 elsewhere.
cl::Paths Areas(const Ring& outer, const std::vector<Ring>& holes) {
  cl::Clipper clipper;
  clipper.AddPath(ToPath(outer), cl::ptSubject, true);
  for (const Ring& hole : holes) clipper.AddPath(ToPath(hole), cl::ptClip, true);
  cl::Paths areas;
  clipper.Execute(cl::ctDifference, areas, cl::pftNonZero, cl::pftNonZero);
  return areas;
}

std::vector<Polygon2> UnitedAreas(const cl::Paths& areas) {
  cl::Clipper clipper;
  clipper.AddPaths(areas, cl::ptSubject, true);
  cl::PolyTree tree;
  clipper.Execute(cl::ctUnion, tree, cl::pftNonZero, cl::pftNonZero);
  std::vector<Polygon2> united;
  for (const cl::PolyNode* node = tree.GetFirst(); node != nullptr; node = node->GetNext()) {
    if (node->IsHole()) continue;
    united.push_back({ToRing(node->Contour), {}});
    for (const cl::PolyNode* hole : node->Childs) united.back().holes.push_back(ToRing(hole->Contour));
  }
  return united;
}

}  // namespace

double SignedArea(const Ring& ring) {
  double twice = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    // Relative to the first corner, so that far from the origin no digits are lost.
    const Eigen::Vector2d a = ring[i] - ring[0];
    const Eigen::Vector2d b = ring[(i + 1) % ring.size()] - ring[0];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * twice;
}

double Area(const Polygon2& polygon) {
  double area = std::abs(SignedArea(polygon.outer));
  for (const Ring& hole : polygon.holes) area -= std::abs(SignedArea(hole));
  return area;
}

double Perimeter(const Polygon2& polygon) {
  double length = Length(polygon.outer);
  for (const Ring& hole : polygon.holes) length += Length(hole);
  return length;
}

bool Contains(const Polygon2& polygon, const Eigen::Vector2d& p) {
  if (!Encloses(polygon.outer, p)) return false;
  for (const Ring& hole : polygon.holes) {
    if (Encloses(hole, p)) return false;
  }
  return true;
}

std::vector<Polygon2> United(std::span<const Ring> rings) {
  cl::Paths areas;
  for (const Ring& ring : rings) {
    const cl::Paths of_ring = Areas(ring, {});
    areas.insert(areas.end(), of_ring.begin(), of_ring.end());
  }
  return UnitedAreas(areas);
}

std::vector<Polygon2> United(std::span<const Polygon2> polygons) {
  cl::Paths areas;
  for (const Polygon2& polygon : polygons) {
    const cl::Paths of_polygon = Areas(polygon.outer, polygon.holes);
    areas.insert(areas.end(), of_polygon.begin(), of_polygon.end());
  }
  return UnitedAreas(areas);
}

}  // namespace ariadne::slam
