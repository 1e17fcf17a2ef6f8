#include <tsl/robin_map.h>

#include <cmath>
#include <optional>

#include "slam/base/error.h"
#include "slam/geometry/box3.h"
#include "slam/reduce/reduce.h"

namespace ariadne::slam {
namespace {

/// A lattice of cubes: cell k covers origin + edge * [k, k + 1) on each axis.
struct Lattice {
  Eigen::Vector3d origin;
  double edge;

  Eigen::Vector3d Cell(const Eigen::Vector3d& p) const { return ((p - origin) / edge).array().floor(); }
  Eigen::Vector3d Center(const Eigen::Vector3d& cell) const {
    return origin + edge * (cell + Eigen::Vector3d::Constant(0.5));
  }
};

struct Members {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  float reflectance = 0.0F;
  int count = 0;
  std::size_t chosen = 0;  // the member with the lowest lot
  std::uint64_t lot = 0;
};

void RequireFinite(const PointCloud& cloud) {
  const std::optional<std::size_t> bad = FirstNonFinite(cloud);
  if (bad) Fail("point {} is not finite", *bad);
}

/// Three cell coordinates in 63 bits.
std::uint64_t Key(const Eigen::Vector3d& cell) {
  constexpr double kHalf = 1 << 20;
  std::uint64_t key = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (!(std::abs(cell[axis]) < kHalf)) {
      Fail("reduce.voxel_size is too small for coordinates this large: at most 2^20 cells to each side");
    }
    key = key << 21 | static_cast<std::uint64_t>(cell[axis] + kHalf);
  }
  return key;
}

/// Spreads every bit over all others (splitmix64).
std::uint64_t Mix(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
  return z ^ (z >> 31);
}

/// The map takes a key's place from its low bits, which alone are those of z: without mixing, all cells of
/// one height collide.
struct KeyHash {
  std::size_t operator()(std::uint64_t key) const { return Mix(key); }
};

/// A number that belongs to a point and looks random.
std::uint64_t Lot(std::uint64_t seed, std::size_t i) { return Mix(seed * 0x9E3779B97F4A7C15ULL + i + 1); }

/// The occupied cells in the order in which the cloud first enters them.
std::vector<Members> Gather(const PointCloud& cloud, const Lattice& lattice, std::uint64_t seed) {
  std::vector<Members> cells;
  tsl::robin_map<std::uint64_t, std::size_t, KeyHash> index;
  index.reserve(cloud.size() / 4);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3d cell = lattice.Cell(cloud.positions[i]);
    const auto [entry, is_new] = index.try_emplace(Key(cell), cells.size());
    if (is_new) cells.push_back({lattice.Center(cell), Eigen::Vector3d::Zero(), 0.0F, 0, i, Lot(seed, i)});
    Members& members = cells[entry->second];
    members.sum += cloud.positions[i] - members.center;  // small numbers keep their digits
    if (!cloud.reflectance.empty()) members.reflectance += cloud.reflectance[i];
    ++members.count;
    const std::uint64_t lot = Lot(seed, i);
    if (lot < members.lot) {
      members.lot = lot;
      members.chosen = i;
    }
  }
  return cells;
}

PointCloud ReduceToCells(const PointCloud& cloud, const Lattice& lattice, Representative representative,
                         std::uint64_t seed) {
  PointCloud reduced;
  for (const Members& members : Gather(cloud, lattice, seed)) {
    switch (representative) {
      case Representative::kCenter:
        reduced.positions.push_back(members.center);
        break;
      case Representative::kMean:
        reduced.positions.push_back(members.center + members.sum / members.count);
        break;
      case Representative::kRandom:
        reduced.positions.push_back(cloud.positions[members.chosen]);
        break;
    }
    if (cloud.reflectance.empty()) continue;
    const bool single = representative == Representative::kRandom;
    reduced.reflectance.push_back(single ? cloud.reflectance[members.chosen]
                                         : members.reflectance / static_cast<float>(members.count));
  }
  return reduced;
}

}  // namespace

PointCloud ReduceVoxels(const PointCloud& cloud, double voxel_size) {
  RequireFinite(cloud);
  return ReduceToCells(cloud, {Eigen::Vector3d::Zero(), voxel_size}, Representative::kMean, 0);
}

PointCloud ReduceOctree(const PointCloud& cloud, double voxel_size, Representative representative,
                        std::uint64_t seed) {
  RequireFinite(cloud);
  if (cloud.empty()) return {};
  constexpr double kMargin = 0.01;  // as in 3DTK, whose leaves can then be compared one by one [m]
  const Box3 box = BoxAround(cloud.positions);
  double edge = box.sizes().maxCoeff() + 2.0 * kMargin;
  while (edge > voxel_size) edge /= 2.0;
  return ReduceToCells(cloud, {box.center(), edge}, representative, seed);
}

}  // namespace ariadne::slam
