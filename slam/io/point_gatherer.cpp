#include "slam/io/point_gatherer.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "slam/io/huge_pages.h"

namespace ariadne::slam {
namespace {

// Normals that are unit to the precision of their text or float are left as they are, so that writing
// what was read gives the same bytes.
constexpr double kNormalTolerance = 1e-5;

constexpr std::string_view kInfiniteReflectance = "has a reflectance that does not fit a float";

/// A number is NaN or infinite where all bits of its exponent are set. Added to its lowest bit, 1 then
/// carries into the sign. (Compilers make vector instructions of this, unlike of std::isfinite.)
bool AllFinite(std::span<const double> numbers) {
  std::uint64_t carries = 0;
  for (const double number : numbers) {
    carries |= (std::bit_cast<std::uint64_t>(number) & 0x7ff0'0000'0000'0000U) + 0x0010'0000'0000'0000U;
  }
  return carries >> 63 == 0;
}

std::span<double> Coordinates(std::vector<Eigen::Vector3d>& vectors, std::size_t first) {
  return {vectors.data()->data() + 3 * first, 3 * (vectors.size() - first)};
}

void CopyVectors(std::span<const Column> columns, const std::array<std::size_t, 3>& fields,
                 std::span<double> to) {
  for (std::size_t axis = 0; axis < 3; ++axis) CopyColumn(columns[fields[axis]], to.subspan(axis), 3);
}

}  // namespace

std::optional<Eigen::Vector3d> UnitNormal(const Eigen::Vector3d& vector) {
  const double length = vector.norm();
  if (!(length > 0.0) || !std::isfinite(length)) return std::nullopt;
  if (std::abs(length - 1.0) <= kNormalTolerance) return vector;
  return vector / length;
}

void PointGatherer::Reserve(std::size_t points) {
  ReserveInHugePages(cloud_.positions, points);
  if (fields_.reflectance) ReserveInHugePages(cloud_.reflectance, points);
  if (fields_.normal) ReserveInHugePages(cloud_.normals, points);
}

std::optional<PointDefect> PointGatherer::AddRow(std::span<const double> row) {
  const auto vector = [&](const std::array<std::size_t, 3>& field) {
    return Eigen::Vector3d(row[field[0]], row[field[1]], row[field[2]]);
  };
  const std::size_t first = cloud_.size();
  cloud_.positions.push_back(vector(fields_.position));
  if (fields_.normal) cloud_.normals.push_back(vector(*fields_.normal));
  if (fields_.reflectance) {
    cloud_.reflectance.push_back(static_cast<float>(row[*fields_.reflectance]));
    if (std::isinf(cloud_.reflectance.back())) return PointDefect{0, kInfiniteReflectance};
  }
  return Check(first);
}

std::optional<PointDefect> PointGatherer::AddBlock(std::span<const Column> columns, std::size_t count) {
  if (count == 0) return std::nullopt;
  const std::size_t first = cloud_.size();
  Resize(first + count);
  CopyVectors(columns, fields_.position, Coordinates(cloud_.positions, first));
  if (fields_.normal) CopyVectors(columns, *fields_.normal, Coordinates(cloud_.normals, first));
  if (fields_.reflectance) {
    const std::span<float> added = std::span(cloud_.reflectance).subspan(first);
    CopyColumn(columns[*fields_.reflectance], added, 1);
    const auto infinite = std::find_if(added.begin(), added.end(), [](float r) { return std::isinf(r); });
    if (infinite != added.end()) {
      return PointDefect{static_cast<std::size_t>(infinite - added.begin()), kInfiniteReflectance};
    }
  }
  return Check(first);
}

std::optional<PointDefect> PointGatherer::Check(std::size_t first) {
  if (!fields_.normal && AllFinite(Coordinates(cloud_.positions, first))) return std::nullopt;
  const std::size_t added_before = first + dropped_.size();
  std::size_t kept = first;
  for (std::size_t i = first; i < cloud_.size(); ++i) {
    const Eigen::Vector3d& p = cloud_.positions[i];
    if (!p.allFinite()) {
      const bool damaged = nan_policy_ == NanPolicy::kDefect || p.array().isInf().any();
      if (damaged) return PointDefect{i - first, "has a coordinate that is NaN or infinite"};
      dropped_.push_back(added_before + (i - first));
      continue;
    }
    if (fields_.normal) {
      const std::optional<Eigen::Vector3d> normal = UnitNormal(cloud_.normals[i]);
      if (!normal) return PointDefect{i - first, "has a normal that is zero, NaN or infinite"};
      cloud_.normals[i] = *normal;
    }
    Keep(i, kept++);
  }
  Resize(kept);
  return std::nullopt;
}

void PointGatherer::Keep(std::size_t from, std::size_t to) {
  cloud_.positions[to] = cloud_.positions[from];
  if (fields_.reflectance) cloud_.reflectance[to] = cloud_.reflectance[from];
  if (fields_.normal) cloud_.normals[to] = cloud_.normals[from];
}

void PointGatherer::Resize(std::size_t points) {
  cloud_.positions.resize(points);
  if (fields_.reflectance) cloud_.reflectance.resize(points);
  if (fields_.normal) cloud_.normals.resize(points);
}

}  // namespace ariadne::slam
