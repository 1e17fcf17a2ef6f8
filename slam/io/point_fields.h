#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "slam/io/stream_reader.h"

namespace ariadne::slam {

/// Which of a file's fields (columns of text, properties of records) are a point's coordinates and
/// attributes; the others are skipped.
struct PointFields {
  std::array<std::size_t, 3> position{0, 1, 2};
  std::optional<std::size_t> reflectance;
  std::optional<std::array<std::size_t, 3>> normal;
};

/// Finds them by the names that people use, in lower or upper case: x y z; reflectance, reflectivity,
/// intensity or remission, also as scalar_...; nx ny nz or normal_x normal_y normal_z.
/// Error at the reader's line where a coordinate is missing or a name stands twice.
PointFields FindPointFields(std::span<const std::string> names, const StreamReader& reader);

}  // namespace ariadne::slam
