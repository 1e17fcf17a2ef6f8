#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "slam/io/scalar.h"
#include "slam/io/stream_reader.h"

namespace ariadne::slam {

struct PlyProperty {
  std::string name;
  ScalarType type = ScalarType::kFloat32;
  std::optional<ScalarType> list_count;  // of a list: how its length is stored
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::size_t line = 0;  // of the header, for messages
  std::vector<PlyProperty> properties;

  bool has_lists() const;
  /// Of a record without lists. [B]
  std::size_t stride() const;
};

enum class PlyFormat { kAscii, kBinaryLittleEndian, kBinaryBigEndian };

struct PlyHeader {
  PlyFormat format = PlyFormat::kAscii;
  std::vector<PlyElement> elements;  // in the order of the data
};

/// Reads up to and with the line "end_header". Error with the line for what is not a PLY header.
PlyHeader ReadPlyHeader(StreamReader& reader);

}  // namespace ariadne::slam
