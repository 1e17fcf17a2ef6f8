#include "slam/map/octree.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "slam/base/error.h"

namespace ariadne::slam {
namespace {

/// The bits of a number below 2^21, two apart.
std::uint64_t Spread(std::int32_t number) {
  auto bits = static_cast<std::uint64_t>(number);
  bits = (bits | bits << 32) & 0x001F00000000FFFF;
  bits = (bits | bits << 16) & 0x001F0000FF0000FF;
  bits = (bits | bits << 8) & 0x100F00F00F00F00F;
  bits = (bits | bits << 4) & 0x10C30C30C30C30C3;
  return (bits | bits << 2) & 0x1249249249249249;
}

std::int32_t Gathered(std::uint64_t bits) {
  bits &= 0x1249249249249249;
  bits = (bits | bits >> 2) & 0x10C30C30C30C30C3;
  bits = (bits | bits >> 4) & 0x100F00F00F00F00F;
  bits = (bits | bits >> 8) & 0x001F0000FF0000FF;
  bits = (bits | bits >> 16) & 0x001F00000000FFFF;
  bits = (bits | bits >> 32) & 0x00000000001FFFFF;
  return static_cast<std::int32_t>(bits);
}

/// A leaf in its place on the Morton curve, on which every cell of every depth is one stretch.
struct PlacedLeaf {
  std::uint64_t morton;  // of the index relative to the lowest corner
  const OctreeLeaf* leaf;

  LeafIndex Index() const { return {Gathered(morton), Gathered(morton >> 1), Gathered(morton >> 2)}; }
};

/// The bricks with any place between two indices.
template <typename Visit>
void ForEachBrick(const OctreeBricks& bricks, const LeafIndex& from, const LeafIndex& to,
                  const Visit& visit) {
  constexpr std::int32_t kEdge = 8;
  const Eigen::Array3d wanted = ((to - from).cast<double>().array() / kEdge).floor() + 2.0;
  if (wanted.prod() >= static_cast<double>(bricks.bricks().size())) {
    for (const OctreeBricks::Brick& brick : bricks.bricks()) visit(brick);
    return;
  }
  const auto first = [](std::int32_t i) { return i & ~(kEdge - 1); };
  for (std::int32_t x = first(from.x()); x <= to.x(); x += kEdge) {
    for (std::int32_t y = first(from.y()); y <= to.y(); y += kEdge) {
      for (std::int32_t z = first(from.z()); z <= to.z(); z += kEdge) {
        if (const OctreeBricks::Brick* const brick = bricks.Find({x, y, z})) visit(*brick);
      }
    }
  }
}

}  // namespace

/// Points that follow one another within one leaf: together they cost one look-up and one rounding.
class Octree::Run {
 public:
  explicit Run(double edge) : edge_(edge) {}

  std::size_t count() const { return count_; }
  const LeafIndex& index() const { return index_; }
  const Eigen::Vector3d& center() const { return center_; }

  void Restart(const LeafIndex& index) {
    index_ = index;
    center_ = edge_ * (index.cast<double>().array() + 0.5);
    sum_.setZero();
    squares_ = {};
    reflectance_ = 0.0;
    count_ = 0;
  }

  void Add(const Eigen::Vector3d& p_map, float reflectance) {
    const Eigen::Vector3d d = p_map - center_;
    sum_ += d;
    squares_[0] += d.x() * d.x();
    squares_[1] += d.x() * d.y();
    squares_[2] += d.x() * d.z();
    squares_[3] += d.y() * d.y();
    squares_[4] += d.y() * d.z();
    squares_[5] += d.z() * d.z();
    reflectance_ += reflectance;
    ++count_;
  }

  CellMoments Moments() const {
    CellMoments moments;
    const double share = 1.0 / static_cast<double>(count_);
    moments.count = count_;
    moments.mean = share * sum_;
    // Offsets are below the edge of a leaf: squares are subtracted without losing what a float can hold.
    moments.scatter = {
        squares_[0] - moments.mean.x() * sum_.x(), squares_[1] - moments.mean.x() * sum_.y(),
        squares_[2] - moments.mean.x() * sum_.z(), squares_[3] - moments.mean.y() * sum_.y(),
        squares_[4] - moments.mean.y() * sum_.z(), squares_[5] - moments.mean.z() * sum_.z()};
    moments.reflectance = share * reflectance_;
    return moments;
  }

 private:
  double edge_;
  LeafIndex index_ = LeafIndex::Zero();
  Eigen::Vector3d center_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d sum_ = Eigen::Vector3d::Zero();
  std::array<double, 6> squares_{};
  double reflectance_ = 0.0;
  std::size_t count_ = 0;
};

Octree::Octree(const OctreeOptions& options)
    : edge_(options.leaf_size), per_edge_(1.0 / options.leaf_size) {
  CheckOptions(options, "octree.");
}

LeafIndex Octree::IndexOf(const Eigen::Vector3d& p_map) const {
  return (per_edge_ * p_map).array().floor().cast<std::int32_t>();
}

void Octree::Check(const PointCloud& cloud_map, const Eigen::Vector3d& viewpoint_map) const {
  if (!viewpoint_map.allFinite()) Fail("the viewpoint of a cloud for the octree is NaN or infinite");
  if (!cloud_map.reflectance.empty() && cloud_map.reflectance.size() != cloud_map.size()) {
    Fail("the cloud has {} points, but {} values of reflectance", cloud_map.size(),
         cloud_map.reflectance.size());
  }
  const double limit = OctreeBricks::kHalfWidth;
  for (std::size_t i = 0; i < cloud_map.size(); ++i) {
    const Eigen::Vector3d& p = cloud_map.positions[i];
    if (((per_edge_ * p).array().abs() < limit).all()) [[likely]]
      continue;
    if (!p.allFinite()) Fail("point {} of a cloud for the octree is NaN or infinite; remove it", i);
    Fail("point {} of a cloud for the octree, at {:.6g} {:.6g} {:.6g}, is more than {:.6g} m from the {}",
         i, p.x(), p.y(), p.z(), limit * edge_, "origin; set a larger octree.leaf_size, or move the map");
  }
}

void Octree::Add(const PointCloud& cloud_map, const Eigen::Vector3d& viewpoint_map) {
  Check(cloud_map, viewpoint_map);
  if (cloud_map.empty()) return;
  const bool reflecting = !cloud_map.reflectance.empty();
  has_reflectance_ = reflecting && (has_reflectance_ || points_ == 0);
  Run run(edge_);
  for (std::size_t i = 0; i < cloud_map.size(); ++i) {
    const Eigen::Vector3d& p = cloud_map.positions[i];
    const LeafIndex index = IndexOf(p);
    if (run.count() == 0 || index != run.index()) {
      if (run.count() > 0) AddRun(run, viewpoint_map);
      run.Restart(index);
    }
    run.Add(p, reflecting ? cloud_map.reflectance[i] : 0.0F);
  }
  AddRun(run, viewpoint_map);
  points_ += cloud_map.size();
}

void Octree::AddRun(const Run& run, const Eigen::Vector3d& viewpoint_map) {
  OctreeLeaf& leaf = bricks_.At(run.index());
  if (leaf.count() == 0) {
    low_ = leaves_ == 0 ? run.index() : LeafIndex(low_.cwiseMin(run.index()));
    high_ = leaves_ == 0 ? run.index() : LeafIndex(high_.cwiseMax(run.index()));
    ++leaves_;
  }
  leaf.Add(run.Moments(), viewpoint_map - run.center());
}

int Octree::max_depth() const {
  int depth = 0;
  while (leaves_ > 0 && (high_ - low_).maxCoeff() >> depth != 0) ++depth;
  return depth;
}

std::vector<OctreeCell> Octree::Cells(int depth) const {
  if (depth < 0) Fail("a depth of an octree is 0 or more, not {}", depth);
  if (leaves_ == 0) return {};
  return CellsBetween(low_, high_, std::max(0, max_depth() - depth));
}

std::vector<OctreeCell> Octree::CellsIn(const Box3& box_map, int depth) const {
  if (depth < 0) Fail("a depth of an octree is 0 or more, not {}", depth);
  const int levels = std::max(0, max_depth() - depth);
  const Eigen::Vector3d low = low_.cast<double>();
  const Box3 cube(low, low.array() + std::exp2(max_depth()) - 1.0);
  const Box3 wanted((per_edge_ * box_map.min()).array().floor(),
                    (per_edge_ * box_map.max()).array().floor());
  const bool is_box = (wanted.min().array() <= wanted.max().array()).all();  // false for NaN
  if (leaves_ == 0 || !is_box || !cube.intersects(wanted)) return {};
  const Box3 common = cube.intersection(wanted);
  // Whole cells: their statistics are those of all leaves in them.
  const auto corner = [&](const Eigen::Vector3d& place) {
    const LeafIndex offset = (place - low).cast<std::int32_t>();
    return LeafIndex(low_ + offset.unaryExpr([&](std::int32_t i) { return i >> levels << levels; }));
  };
  return CellsBetween(corner(common.min()), corner(common.max()).array() + ((1 << levels) - 1), levels);
}

std::vector<OctreeCell> Octree::CellsBetween(const LeafIndex& from, const LeafIndex& to, int levels) const {
  std::vector<PlacedLeaf> leaves;
  ForEachBrick(bricks_, from, to, [&](const OctreeBricks::Brick& brick) {
    brick.ForEach([&](const LeafIndex& index, const OctreeLeaf& leaf) {
      if ((index.array() < from.array()).any() || (index.array() > to.array()).any()) return;
      const LeafIndex place = index - low_;
      leaves.push_back({Spread(place.x()) | Spread(place.y()) << 1 | Spread(place.z()) << 2, &leaf});
    });
  });
  std::ranges::sort(leaves, {}, &PlacedLeaf::morton);
  std::vector<OctreeCell> cells;
  const double edge = std::ldexp(edge_, levels);
  for (auto first = leaves.begin(); first != leaves.end();) {
    const LeafIndex corner =
        first->Index().unaryExpr([&](std::int32_t i) { return i >> levels << levels; });
    const Eigen::Vector3d center =
        edge_ * (low_ + corner).cast<double>() + Eigen::Vector3d::Constant(0.5 * edge);
    const std::uint64_t cell = first->morton >> 3 * levels;
    CellMoments sum;
    for (; first != leaves.end() && first->morton >> 3 * levels == cell; ++first) {
      CellMoments moments = first->leaf->Moments();
      const Eigen::Vector3d leaf_center = edge_ * ((low_ + first->Index()).cast<double>().array() + 0.5);
      moments.mean += leaf_center - center;
      sum = sum.count == 0 ? moments : Merged(sum, moments);
    }
    cells.push_back({center, edge, sum.count, center + sum.mean, NormalOf(sum),
                     has_reflectance_ ? static_cast<float>(sum.reflectance) : 0.0F});
  }
  return cells;
}

}  // namespace ariadne::slam
