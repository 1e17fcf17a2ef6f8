#include "slam/io/records.h"

#include <algorithm>
#include <string_view>

namespace ariadne::slam {
namespace {

// Small enough for the records and their points to stay in the cache.
constexpr std::size_t kBlockSize = 1 << 14;  // [B]

std::vector<Column> ColumnsOf(const RecordLayout& layout, std::string_view records) {
  std::vector<Column> columns;
  for (const RecordLayout::Field& field : layout.fields) {
    columns.push_back({field.type, records.data() + field.offset, layout.stride, layout.big_endian});
  }
  return columns;
}

}  // namespace

void GatherRecords(StreamReader& reader, const RecordLayout& layout, std::optional<std::uint64_t> count,
                   PointGatherer& points) {
  const std::uint64_t per_block = std::max<std::size_t>(1, kBlockSize / layout.stride);
  for (std::uint64_t done = 0; !count || done < *count;) {
    const std::uint64_t wanted = count ? std::min(*count - done, per_block) : per_block;
    const std::uint64_t first_byte = reader.offset();
    const std::string_view records = reader.NextBytes(static_cast<std::size_t>(wanted) * layout.stride);
    const std::size_t complete = records.size() / layout.stride;
    if (records.size() % layout.stride != 0 || (count && complete < wanted)) {
      reader.FailAtByte(reader.offset(), "the file ends in point {}, of {} bytes; it is truncated",
                        done + complete + 1, layout.stride);
    }
    if (complete == 0) return;
    if (const auto defect = points.AddBlock(ColumnsOf(layout, records), complete)) {
      reader.FailAtByte(first_byte + defect->index * layout.stride, "point {} {}; remove the point",
                        done + defect->index + 1, defect->problem);
    }
    done += complete;
  }
}

void SkipBytes(StreamReader& reader, std::uint64_t count) {
  while (count > 0) {
    const std::size_t skipped =
        reader.NextBytes(std::min<std::uint64_t>(count, StreamReader::kChunkSize)).size();
    if (skipped == 0) {
      reader.FailAtByte(reader.offset(), "the file ends where {} more bytes are expected", count);
    }
    count -= skipped;
  }
}

void CheckOnlyPaddingFollows(StreamReader& reader) {
  constexpr std::string_view kPadding("\0 \t\r\n", 5);
  std::uint64_t first_byte = reader.offset();
  while (true) {
    const std::string_view bytes = reader.NextBytes(StreamReader::kChunkSize);
    if (bytes.empty()) return;
    const std::size_t found = bytes.find_first_not_of(kPadding);
    if (found != std::string_view::npos) {
      reader.FailAtByte(first_byte + found,
                        "data follows the last point; the counts of the header are too low");
    }
    first_byte += bytes.size();
  }
}

}  // namespace ariadne::slam
