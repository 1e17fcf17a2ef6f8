#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "slam/io/records.h"
#include "slam/io/stream_reader.h"

namespace ariadne::slam {

enum class PcdEncoding { kAscii, kBinary, kBinaryCompressed };

struct PcdHeader {
  /// The numbers of a point. A field with COUNT n is n columns without a name, since none of them can be a
  /// coordinate.
  std::vector<std::string> columns;
  RecordLayout layout;  // of the columns
  std::uint64_t width = 0;
  std::uint64_t height = 1;
  std::uint64_t points = 0;  // width * height
  std::string points_place;  // "file:line" of this number, for messages
  PcdEncoding encoding = PcdEncoding::kAscii;
};

/// Reads up to and with the line DATA. Error with the line for what is not a header or contradicts itself.
PcdHeader ReadPcdHeader(StreamReader& reader);

}  // namespace ariadne::slam
