#include "slam/map/scan_mesh_triangles.h"

#include <cmath>
#include <limits>

#include "slam/base/error.h"
#include "slam/map/scan_mesh_surface.h"

namespace ariadne::slam {
namespace {

using Triangle = std::array<std::size_t, 3>;

/// Joins the slices of a scan pairwise by strips of triangles.
class Strips {
 public:
  Strips(const ScanGrid& grid, const ScanMeshOptions& options)
      : grid_(grid),
        continuity_(FindContinuity(grid, options)),
        surfaces_(FitSurfaces(grid, continuity_, options)),
        min_cosine_(std::cos(options.max_incidence)) {
    for (std::size_t i = 0; i < grid.beams.size(); ++i) {
      const double range = options.smooth ? surfaces_[i].range : grid.beams[i].range;
      positions_.push_back(range * grid.beams[i].direction_laser);
    }
  }

  std::vector<Triangle> Run() {
    for (std::size_t s = 0; s + 1 < grid_.slices.size(); ++s) Join(grid_.slices[s], grid_.slices[s + 1]);
    return std::move(triangles_);
  }

  const Eigen::Vector3d& position(std::size_t i) const { return positions_[i]; }

 private:
  /// Goes along both slices from right to left, and makes a triangle of each step on one of them and the
  /// place reached on the other.
  void Join(const std::vector<std::size_t>& a, const std::vector<std::size_t>& b) {
    if (a.empty() || b.empty()) return;
    std::size_t i = 0, j = 0;
    while (i + 1 < a.size() || j + 1 < b.size()) {
      if (j + 1 == b.size() || (i + 1 < a.size() && StepsOnFirst(a[i], a[i + 1], b[j], b[j + 1]))) {
        Add(a[i], a[i + 1], b[j]);
        ++i;
      } else {
        Add(b[j], b[j + 1], a[i]);
        ++j;
      }
    }
  }

  /// To the next bearing; where these are equal, over the shorter diagonal.
  bool StepsOnFirst(std::size_t a, std::size_t a_next, std::size_t b, std::size_t b_next) const {
    const double ahead = grid_.beams[a_next].bearing - grid_.beams[b_next].bearing;
    if (std::abs(ahead) > 0.25 * grid_.bearing_step) return ahead < 0.0;
    return (positions_[a_next] - positions_[b]).squaredNorm() <=
           (positions_[a] - positions_[b_next]).squaredNorm();
  }

  /// The triangle of two neighbours of a slice and a beam of the next or the one before.
  void Add(std::size_t right, std::size_t left, std::size_t across) {
    if (grid_.beams[right].left != left || !continuity_[right].left) return;
    if (!AreLinked(right, across) && !AreLinked(left, across)) return;
    if (!IsSeenWell({right, left, across})) return;
    const auto direction = [&](std::size_t i) { return grid_.beams[i].direction_laser; };
    const double solid_angle = direction(right).dot(direction(left).cross(direction(across)));  // twice
    constexpr double kNothing = 1e-9;  // all slices have the beams along the tilt axis in common
    if (std::abs(solid_angle) < kNothing) return;
    triangles_.push_back(solid_angle < 0.0 ? Triangle{right, left, across} : Triangle{left, right, across});
  }

  bool AreLinked(std::size_t i, std::size_t across) const {
    const ScanGrid::Beam& beam = grid_.beams[i];
    const ScanGrid::Beam& other = grid_.beams[across];
    return (beam.after == across && continuity_[i].after) ||
           (beam.before == across && continuity_[i].before) ||
           (other.after == i && continuity_[across].after) ||
           (other.before == i && continuity_[across].before);
  }

  /// By the surfaces at its corners, as neighbouring beams can lie so close that noise turns a triangle.
  bool IsSeenWell(const Triangle& triangle) const {
    double cosines = 0.0;
    int known = 0;
    for (const std::size_t i : triangle) {
      if (surfaces_[i].normal_laser.isZero(0.0)) continue;
      cosines -= surfaces_[i].normal_laser.dot(grid_.beams[i].direction_laser);
      ++known;
    }
    if (known > 0) return cosines >= known * min_cosine_;
    const Eigen::Vector3d& corner = positions_[triangle[0]];
    const Eigen::Vector3d across =
        (positions_[triangle[1]] - corner).cross(positions_[triangle[2]] - corner);
    return std::abs(across.dot(grid_.beams[triangle[0]].direction_laser)) >= min_cosine_ * across.norm();
  }

  const ScanGrid& grid_;
  std::vector<Continuity> continuity_;
  std::vector<BeamSurface> surfaces_;
  double min_cosine_;
  std::vector<Eigen::Vector3d> positions_;
  std::vector<Triangle> triangles_;
};

}  // namespace

ScanTriangles TrianglesOf(const PointCloud& cloud_laser, const ScanMeshOptions& options,
                          const std::string& name) {
  constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();
  const ScanGrid grid = GridOf(cloud_laser, options.max_gap, name);
  Strips strips(grid, options);
  ScanTriangles mesh;
  std::vector<std::uint32_t> vertices(cloud_laser.size(), kUnused);
  const auto vertex = [&](std::size_t i) {
    if (vertices[i] == kUnused) {
      vertices[i] = static_cast<std::uint32_t>(mesh.vertices_laser.size());
      mesh.vertices_laser.push_back(strips.position(i));
      if (!cloud_laser.reflectance.empty()) mesh.reflectance.push_back(cloud_laser.reflectance[i]);
    }
    return vertices[i];
  };
  for (const Triangle& t : strips.Run())
    mesh.triangles.push_back({vertex(t[0]), vertex(t[1]), vertex(t[2])});
  return mesh;
}

}  // namespace ariadne::slam
