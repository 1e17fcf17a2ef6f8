#include "slam/extract/unite_surfaces.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace ariadne::slam {
namespace {

using Box2 = Eigen::AlignedBox2d;

/// A plane relative to another's frame: turns about x and y [rad], shift along z at the origin [m].
struct RelativePlane {
  Eigen::Vector3d turns_and_shift = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

/// For the same plane, how turns and shift at the frame of b are those at the frame of a. Turning b moves
/// what is away from its origin.
Eigen::Matrix3d Transport(const Pose3& T_a_b) {
  const Eigen::Matrix3d R = T_a_b.RotationMatrix();
  const Eigen::Vector2d away = -T_a_b.translation.head<2>();  // a's origin from b's
  Eigen::Matrix3d M = Eigen::Matrix3d::Identity();
  M.topLeftCorner<2, 2>() = R.topLeftCorner<2, 2>();
  M.row(2).head<2>() = Eigen::RowVector2d(away.y(), -away.x()) * R.topLeftCorner<2, 2>();
  return M;
}

RelativePlane Relative(const PlanarSurface& a, const PlanarSurface& b,
                       const Eigen::Matrix3d& covariance_b) {
  const Pose3 T_a_b = a.T_frame_plane.Inverse() * b.T_frame_plane;
  const Eigen::Vector3d normal = T_a_b.rotation * Eigen::Vector3d::UnitZ();
  const double shift = normal.dot(T_a_b.translation) / normal.z();
  const Eigen::Matrix3d M = Transport(T_a_b);
  return {{-normal.y() / normal.z(), normal.x() / normal.z(), shift}, M * covariance_b * M.transpose()};
}

Eigen::Matrix3d Tolerance(const UniteOptions& options) {
  const double angle = options.angle_tolerance * options.angle_tolerance;
  return Eigen::Vector3d(angle, angle, options.distance_tolerance * options.distance_tolerance)
      .asDiagonal();
}

bool AreCoplanar(const PlanarSurface& a, const PlanarSurface& b, const UniteOptions& options) {
  if (PlaneOf(a).normal.dot(PlaneOf(b).normal) < std::cos(options.max_angle)) return false;
  const RelativePlane relative = Relative(a, b, b.covariance + Tolerance(options));
  const Eigen::Matrix3d covariance = relative.covariance + a.covariance + Tolerance(options);
  const Eigen::LDLT<Eigen::Matrix3d> factor(covariance);
  const double squared = relative.turns_and_shift.dot(factor.solve(relative.turns_and_shift));
  return squared <= options.max_deviation * options.max_deviation;
}

/// The outlines of b as a sees them.
std::vector<Polygon2> ProjectedOutlines(const PlanarSurface& a, const PlanarSurface& b) {
  const Pose3 T_a_b = a.T_frame_plane.Inverse() * b.T_frame_plane;
  const auto project = [&](Ring& ring) {
    for (Eigen::Vector2d& q : ring) q = (T_a_b * Eigen::Vector3d(q.x(), q.y(), 0.0)).head<2>();
  };
  std::vector<Polygon2> outlines = b.outlines;
  for (Polygon2& outline : outlines) {
    project(outline.outer);
    for (Ring& hole : outline.holes) project(hole);
  }
  return outlines;
}

Box2 BoxAround(const Ring& ring) {
  Box2 box;
  for (const Eigen::Vector2d& q : ring) box.extend(q);
  return box;
}

double DistanceToEdge(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d ab = b - a;
  const double squared = ab.squaredNorm();
  const double share = squared > 0.0 ? std::clamp(ab.dot(p - a) / squared, 0.0, 1.0) : 0.0;
  return (a + share * ab - p).norm();
}

/// Whether two edges cross, each with its ends on both sides of the other.
bool Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
           const Eigen::Vector2d& d) {
  const auto is_left = [](const Eigen::Vector2d& p, const Eigen::Vector2d& q, const Eigen::Vector2d& r) {
    return (q.x() - p.x()) * (r.y() - p.y()) > (q.y() - p.y()) * (r.x() - p.x());
  };
  return is_left(a, b, c) != is_left(a, b, d) && is_left(c, d, a) != is_left(c, d, b);
}

/// Whether two edges come that near to each other: where they do not cross, an end is nearest.
bool AreEdgesNear(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                  const Eigen::Vector2d& d, double gap) {
  return DistanceToEdge(a, c, d) <= gap || DistanceToEdge(b, c, d) <= gap ||
         DistanceToEdge(c, a, b) <= gap || DistanceToEdge(d, a, b) <= gap || Cross(a, b, c, d);
}

bool AreNear(const Ring& ring, const Ring& other, double gap) {
  Box2 around = BoxAround(other);
  if (ring.empty() || other.empty()) return false;
  around = Box2(around.min() - Eigen::Vector2d(gap, gap), around.max() + Eigen::Vector2d(gap, gap));
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Eigen::Vector2d &a = ring[i], &b = ring[(i + 1) % ring.size()];
    if (!around.intersects(BoxAround({a, b}))) continue;
    for (std::size_t k = 0; k < other.size(); ++k) {
      if (AreEdgesNear(a, b, other[k], other[(k + 1) % other.size()], gap)) return true;
    }
  }
  return false;
}

bool AreNear(const Polygon2& a, const Polygon2& b, double gap) {
  if (a.outer.empty() || b.outer.empty()) return false;
  if (Contains(a, b.outer[0]) || Contains(b, a.outer[0]) || AreNear(a.outer, b.outer, gap)) return true;
  return std::ranges::any_of(a.holes, [&](const Ring& hole) { return AreNear(b.outer, hole, gap); }) ||
         std::ranges::any_of(b.holes, [&](const Ring& hole) { return AreNear(a.outer, hole, gap); });
}

bool AreNear(const std::vector<Polygon2>& a, const std::vector<Polygon2>& b, double gap) {
  return std::ranges::any_of(a, [&](const Polygon2& of_a) {
    return std::ranges::any_of(b, [&](const Polygon2& of_b) { return AreNear(of_a, of_b, gap); });
  });
}

/// The plane frame after it has turned and shifted, as the covariance means it.
Pose3 Moved(const Pose3& T_frame_plane, const Eigen::Vector3d& turns_and_shift) {
  const Eigen::Vector3d normal = Eigen::Vector3d(turns_and_shift[1], -turns_and_shift[0], 1.0).normalized();
  const Pose3 T_plane_moved{Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), normal),
                            {0.0, 0.0, turns_and_shift[2]}};
  return T_frame_plane * T_plane_moved;
}

/// Also of a plane that is said to be known exactly.
Eigen::Matrix3d Inverse(const Eigen::Matrix3d& covariance) {
  constexpr double kLeast = 1e-14;  // a tenth of a micrometre
  return (covariance + kLeast * Eigen::Matrix3d::Identity()).ldlt().solve(Eigen::Matrix3d::Identity());
}

PlanarSurface Unite(const PlanarSurface& a, const PlanarSurface& b) {
  const auto points_a = static_cast<double>(a.points), points_b = static_cast<double>(b.points);
  const double share = points_b / std::max(1.0, points_a + points_b);
  const RelativePlane relative = Relative(a, b, b.covariance);
  const Eigen::Matrix3d information_b = share * Inverse(relative.covariance);
  const Eigen::Matrix3d covariance = Inverse((1.0 - share) * Inverse(a.covariance) + information_b);
  PlanarSurface united;
  united.T_frame_plane = Moved(a.T_frame_plane, covariance * (information_b * relative.turns_and_shift));
  united.covariance = 0.5 * (covariance + covariance.transpose());
  united.points = a.points + b.points;
  united.rms = std::sqrt((1.0 - share) * a.rms * a.rms + share * b.rms * b.rms);
  std::vector<Polygon2> outlines = ProjectedOutlines(united, a);
  std::ranges::move(ProjectedOutlines(united, b), std::back_inserter(outlines));
  united.outlines = United(outlines);
  return united;
}

}  // namespace

std::vector<PlanarSurface> UniteSurfaces(std::vector<PlanarSurface> surfaces, const UniteOptions& options) {
  CheckOptions(options, "unite.");
  std::ranges::stable_sort(surfaces, std::ranges::greater{}, &PlanarSurface::points);
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    for (std::size_t j = i + 1; j < surfaces.size();) {
      const bool one =
          AreCoplanar(surfaces[i], surfaces[j], options) &&
          AreNear(surfaces[i].outlines, ProjectedOutlines(surfaces[i], surfaces[j]), options.max_gap);
      if (!one) {
        ++j;
        continue;
      }
      surfaces[i] = Unite(surfaces[i], surfaces[j]);
      surfaces.erase(surfaces.begin() + static_cast<std::ptrdiff_t>(j));
      j = i + 1;  // what has grown may reach those that were too far
    }
  }
  return surfaces;
}

}  // namespace ariadne::slam
