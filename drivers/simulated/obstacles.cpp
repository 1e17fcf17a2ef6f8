#include "drivers/simulated/obstacles.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace ariadne::drivers {
namespace {

constexpr double kCellsPerSide = 1000.0;  // at most; a larger world gets larger cells

std::array<Eigen::Vector3d, 3> TriangleAt(const TriangleMesh& mesh, std::size_t triangle,
                                          const slam::Pose3& T_map_body) {
  const auto& v = mesh.triangles[triangle];
  return {T_map_body * mesh.vertices[v[0]], T_map_body * mesh.vertices[v[1]],
          T_map_body * mesh.vertices[v[2]]};
}

void Deepen(Contact& deepest, double depth, std::uint32_t body) {
  if (depth > deepest.depth) deepest = {depth, body};
}

}  // namespace

Obstacles::Obstacles(const World& world, const FootprintOptions& footprint)
    : world_(&world),
      half_size_(0.5 * footprint.length, 0.5 * footprint.width),
      heights_{footprint.lowest, footprint.highest} {
  CheckOptions(footprint, "footprint.");
  if (!(footprint.highest >= footprint.lowest + 0.01)) {
    Fail("footprint.highest is {} m, but must be 1 cm or more above footprint.lowest, {} m",
         footprint.highest, footprint.lowest);
  }
  for (std::uint32_t body = 0; body < world.bodies.size(); ++body) {
    world.bodies[body].motion.moves() ? AddMoving(body) : AddStanding(body);
  }
  FillGrid();
}

void Obstacles::AddStanding(std::uint32_t body) {
  const TriangleMesh& mesh = world_->bodies[body].mesh_body;
  const slam::Pose3 T_map_body = PoseAt(world_->bodies[body].motion, 0.0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Outline outline = OutlineBetween(TriangleAt(mesh, t, T_map_body), heights_);
    if (!outline.empty()) standing_.push_back({outline, body});
  }
}

void Obstacles::AddMoving(std::uint32_t body) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : world_->bodies[body].mesh_body.vertices) box.extend(p);
  if (!box.isEmpty()) moving_.push_back({box.center(), 0.5 * box.diagonal().norm(), body});
}

void Obstacles::FillGrid() {
  Eigen::AlignedBox2d box;
  for (const Standing& part : standing_) {
    for (const Eigen::Vector2d& corner : part.outline_map.corners()) box.extend(corner);
  }
  if (box.isEmpty()) return;
  grid_origin_ = box.min();
  cell_size_ = std::max(cell_size_, box.sizes().maxCoeff() / kCellsPerSide);
  grid_size_ = (box.sizes() / cell_size_).array().floor().cast<int>().matrix() + Eigen::Vector2i::Ones();
  grid_.resize(static_cast<std::size_t>(grid_size_.prod()));
  for (std::uint32_t i = 0; i < standing_.size(); ++i) {
    const Cells cells = CellsAround(standing_[i].outline_map.corners());
    for (int y = cells.from.y(); y <= cells.to.y(); ++y) {
      for (int x = cells.from.x(); x <= cells.to.x(); ++x) {
        grid_[CellAt(x, y)].push_back(i);
      }
    }
  }
}

Obstacles::Cells Obstacles::CellsAround(std::span<const Eigen::Vector2d> points) const {
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& p : points) box.extend(p);
  const auto cell_of = [&](const Eigen::Vector2d& p) -> Eigen::Vector2i {
    const Eigen::Array2d cell = ((p - grid_origin_) / cell_size_).array().floor();
    const Eigen::Array2d last = grid_size_.cast<double>().array() - 1.0;
    return cell.max(0.0).min(last).cast<int>().matrix();  // points outside count to the cells at the rim
  };
  return {cell_of(box.min()), cell_of(box.max())};
}

Contact Obstacles::ContactAt(const slam::Pose2& T_map_base, double time) const {
  Contact deepest = TouchStanding(T_map_base);
  for (const Moving& moving : moving_) {
    Deepen(deepest, TouchMoving(moving, T_map_base, time), moving.body);
  }
  return deepest;
}

bool Obstacles::Block(const slam::Pose2& T_map_from, const slam::Pose2& T_map_to, double time) const {
  if (TouchStanding(T_map_to).depth > 0.0) return true;
  for (const Moving& moving : moving_) {
    if (TouchMoving(moving, T_map_to, time) == 0.0) continue;
    if (TouchMoving(moving, T_map_from, time) == 0.0) return true;
    const Eigen::Vector2d middle = Middle(moving, time);
    if ((T_map_to.translation - middle).norm() < (T_map_from.translation - middle).norm()) return true;
  }
  return false;
}

Contact Obstacles::TouchStanding(const slam::Pose2& T_map_base) const {
  Contact deepest;
  if (grid_.empty()) return deepest;
  const Eigen::Vector2d a = half_size_, b(a.x(), -a.y());
  const std::array<Eigen::Vector2d, 4> corners{T_map_base * a, T_map_base * b, T_map_base * -a,
                                               T_map_base * -b};
  const Cells cells = CellsAround(corners);
  for (int y = cells.from.y(); y <= cells.to.y(); ++y) {
    for (int x = cells.from.x(); x <= cells.to.x(); ++x) {
      for (const std::uint32_t i : grid_[CellAt(x, y)]) {
        const Standing& part = standing_[i];
        Deepen(deepest, OverlapDepth(part.outline_map, T_map_base, half_size_), part.body);
      }
    }
  }
  return deepest;
}

Eigen::Vector2d Obstacles::Middle(const Moving& moving, double time) const {
  return (PoseAt(world_->bodies[moving.body].motion, time) * moving.center_body).head<2>();
}

double Obstacles::TouchMoving(const Moving& moving, const slam::Pose2& T_map_base, double time) const {
  const double distance = (Middle(moving, time) - T_map_base.translation).norm();
  if (distance > moving.radius + half_size_.norm()) return 0.0;
  const Body& body = world_->bodies[moving.body];
  const slam::Pose3 T_map_body = PoseAt(body.motion, time);
  double depth = 0.0;
  for (std::size_t t = 0; t < body.mesh_body.triangles.size(); ++t) {
    const Outline outline = OutlineBetween(TriangleAt(body.mesh_body, t, T_map_body), heights_);
    depth = std::max(depth, OverlapDepth(outline, T_map_base, half_size_));
  }
  return depth;
}

}  // namespace ariadne::drivers
