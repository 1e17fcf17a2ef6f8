#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "slam/io/point_fields.h"
#include "slam/io/scalar.h"
#include "slam/scan/point_cloud.h"

namespace ariadne::slam {

/// A point that a reader must not accept; the reader knows its line or byte.
struct PointDefect {
  std::size_t index = 0;     // among the points just added
  std::string_view problem;  // "is ...": the end of a sentence
};

/// Gathers a cloud from rows of numbers or blocks of binary records, as they come from a file, and lets
/// only sound points in: finite coordinates, normals of unit length (scaled where they are not), and a
/// reflectance that is NaN (not measured) or fits a float.
class PointGatherer {
 public:
  /// What NaN in a coordinate means: damage, or a direction without a measurement.
  enum class NanPolicy { kDefect, kDrop };

  PointGatherer(const PointFields& fields, NanPolicy nan_policy)
      : fields_(fields), nan_policy_(nan_policy) {}

  /// Makes room, so that the points need no more memory than their own.
  void Reserve(std::size_t points);

  /// Adds one point; `row` has all fields of the file.
  std::optional<PointDefect> AddRow(std::span<const double> row);
  /// Adds points [0, count) of `columns`, one for each field of the file.
  std::optional<PointDefect> AddBlock(std::span<const Column> columns, std::size_t count);

  /// What was gathered so far.
  const PointCloud& cloud() const { return cloud_; }
  PointCloud TakeCloud() { return std::move(cloud_); }
  /// Which of all added points were dropped (ascending).
  const std::vector<std::size_t>& dropped() const { return dropped_; }

 private:
  std::optional<PointDefect> Check(std::size_t first);
  void Keep(std::size_t from, std::size_t to);
  void Resize(std::size_t points);

  PointFields fields_;
  NanPolicy nan_policy_;
  PointCloud cloud_;
  std::vector<std::size_t> dropped_;
};

/// Whether a vector can be a normal, and the normal: null or non-finite vectors cannot.
std::optional<Eigen::Vector3d> UnitNormal(const Eigen::Vector3d& vector);

}  // namespace ariadne::slam
