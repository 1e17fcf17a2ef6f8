#include <algorithm>

#include "slam/io/pcd.h"
#include "slam/io/pcd_compressed.h"
#include "slam/io/point_gatherer.h"
#include "slam/io/row_parser.h"

namespace ariadne::slam {
namespace {

[[noreturn]] void FailForSize(const PcdHeader& header, std::uint64_t bytes) {
  Fail(
      "{}: the header announces {} points, but only {} bytes follow; the file is truncated or POINTS wrong",
      header.points_place, header.points, bytes);
}

/// Makes room for the points of the header, if the file can hold them.
void Reserve(const StreamReader& reader, const PcdHeader& header, std::uint64_t smallest_point,
             PointGatherer& points) {
  const std::uint64_t bytes = reader.Remaining().value_or(0);
  // One byte more, because the last line of a text need not have an end.
  if (reader.Remaining() && header.points > (bytes + 1) / smallest_point) FailForSize(header, bytes);
  points.Reserve(static_cast<std::size_t>(std::min(header.points, (bytes + 1) / smallest_point)));
}

void ReadAscii(StreamReader& reader, const PcdHeader& header, PointGatherer& points) {
  Reserve(reader, header, 2 * header.columns.size(), points);
  RowParser parser(reader);
  for (std::uint64_t row = 0; row < header.points;) {
    const std::optional<std::string_view> line = reader.NextLine();
    if (!line) {
      Fail("{}:{}: the file ends after {} of {} points; it is truncated", reader.name(), reader.line() + 1,
           row, header.points);
    }
    const std::span<const double> numbers = parser.Parse(*line);
    if (numbers.empty()) continue;
    if (numbers.size() != header.columns.size()) {
      reader.FailAtLine("found {} numbers, expected {}; complete or remove the line (and lower POINTS)",
                        numbers.size(), header.columns.size());
    }
    if (const auto defect = points.AddRow(numbers)) {
      reader.FailAtLine("the point {}; remove it", defect->problem);
    }
    ++row;
  }
  CheckOnlyBlankLinesFollow(reader, "POINTS is too low");
}

void ReadBinary(StreamReader& reader, const PcdHeader& header, PointGatherer& points) {
  Reserve(reader, header, header.layout.stride, points);
  GatherRecords(reader, header.layout, header.points, points);
  CheckOnlyPaddingFollows(reader);
}

void ReadCompressed(StreamReader& reader, const PcdHeader& header, PointGatherer& points) {
  const std::vector<char> fields = ReadCompressedFields(reader, header);
  CheckOnlyPaddingFollows(reader);
  std::vector<Column> columns;
  for (const RecordLayout::Field& field : header.layout.fields) {
    // Right for fields of one number, which all coordinates and attributes are.
    columns.push_back({field.type, fields.data() + header.points * field.offset, SizeOf(field.type)});
  }
  points.Reserve(static_cast<std::size_t>(header.points));
  if (const auto defect = points.AddBlock(columns, static_cast<std::size_t>(header.points))) {
    Fail("{}: point {} {}; remove it", reader.name(), defect->index + 1, defect->problem);
  }
}

/// Where the rows of a grid begin, after some of its points were dropped.
std::vector<std::size_t> RowBegins(const PcdHeader& header, const std::vector<std::size_t>& dropped) {
  std::vector<std::size_t> begins;
  for (std::uint64_t row = 0; row < header.height; ++row) {
    const auto first = static_cast<std::size_t>(row * header.width);
    const auto dropped_before = std::lower_bound(dropped.begin(), dropped.end(), first) - dropped.begin();
    begins.push_back(first - static_cast<std::size_t>(dropped_before));
  }
  return begins;
}

}  // namespace

CloudFile ReadPcd(std::istream& in, const std::string& name) {
  StreamReader reader(in, name);
  const PcdHeader header = ReadPcdHeader(reader);
  PointGatherer points(FindPointFields(header.columns, reader), PointGatherer::NanPolicy::kDrop);
  if (header.encoding == PcdEncoding::kAscii) ReadAscii(reader, header, points);
  if (header.encoding == PcdEncoding::kBinary) ReadBinary(reader, header, points);
  if (header.encoding == PcdEncoding::kBinaryCompressed) ReadCompressed(reader, header, points);
  CloudFile file{points.TakeCloud(), points.dropped().size()};
  if (header.height > 1 && header.width > 1) file.cloud.slice_begin = RowBegins(header, points.dropped());
  return file;
}

}  // namespace ariadne::slam
