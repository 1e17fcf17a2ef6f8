#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "slam/io/point_gatherer.h"
#include "slam/io/scalar.h"
#include "slam/io/stream_reader.h"

namespace ariadne::slam {

/// How a binary file stores a point: fields at fixed places of a record.
struct RecordLayout {
  struct Field {
    ScalarType type = ScalarType::kFloat32;
    std::size_t offset = 0;  // [B]
  };
  std::vector<Field> fields;
  std::size_t stride = 0;  // of a record [B], at most StreamReader::kChunkSize
  bool big_endian = false;

  void Append(ScalarType type, std::size_t count = 1) {
    fields.push_back({type, stride});
    stride += SizeOf(type) * count;
  }
};

/// Reads `count` records into `points`, or all to the end of the file. Error with the byte where the file
/// ends before or within a record, or a point is not sound.
void GatherRecords(StreamReader& reader, const RecordLayout& layout, std::optional<std::uint64_t> count,
                   PointGatherer& points);

/// Skips bytes; Error where the file ends before.
void SkipBytes(StreamReader& reader, std::uint64_t count);

/// Error unless only zeros and blanks follow, with which some programs fill up their files.
void CheckOnlyPaddingFollows(StreamReader& reader);

}  // namespace ariadne::slam
