#include "experiments/render/disc_radii.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace ariadne::experiments {
namespace {

constexpr double kCell = 0.25;     // side of the cubes in which points are counted [m]
constexpr double kOverlap = 0.85;  // radius per distance of neighbours, so that a pixel blends a few discs
constexpr double kSurfaceCount = 8.0;  // points in a cube that make it part of a surface

/// The cube of a point as one number. Two cubes may share it, which makes a disc a little smaller somewhere
/// and is harmless.
std::uint64_t CubeHash(const Eigen::Vector3d& p) {
  const auto index = [](double x) {
    return static_cast<std::uint64_t>(
        static_cast<std::int64_t>(std::clamp(std::floor(x / kCell), -1e15, 1e15)));
  };
  std::uint64_t hash = index(p.x()) * 0x9E3779B97F4A7C15ULL;
  hash = (hash ^ (hash >> 29U) ^ index(p.y())) * 0xBF58476D1CE4E5B9ULL;
  hash = (hash ^ (hash >> 32U) ^ index(p.z())) * 0x94D049BB133111EBULL;
  return hash ^ (hash >> 31U);
}

/// n points share the cross section of their cube with a surface.
float RadiusFor(std::uint32_t count) {
  const double spacing = kCell / std::sqrt(count);
  return static_cast<float>(kOverlap * spacing * std::min(1.0, count / kSurfaceCount));
}

}  // namespace

std::vector<float> DiscRadii(const std::vector<Eigen::Vector3d>& positions) {
  // Counts without keys: there are far fewer cubes than points, so few of them collide.
  std::size_t slots = 1024;
  while (slots < positions.size()) slots *= 2;
  std::vector<std::uint32_t> counts(slots, 0);
  std::vector<std::size_t> slot_of;
  slot_of.reserve(positions.size());
  for (const Eigen::Vector3d& p : positions) {
    slot_of.push_back(CubeHash(p) & (slots - 1));
    ++counts[slot_of.back()];
  }
  std::vector<float> radii;
  radii.reserve(positions.size());
  for (const std::size_t slot : slot_of) radii.push_back(RadiusFor(counts[slot]));
  return radii;
}

}  // namespace ariadne::experiments
