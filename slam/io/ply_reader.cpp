#include <algorithm>

#include "slam/io/ply.h"
#include "slam/io/ply_header.h"
#include "slam/io/ply_rows.h"
#include "slam/io/point_gatherer.h"
#include "slam/io/records.h"

namespace ariadne::slam {
namespace {

const PlyElement& RequireVertices(const StreamReader& reader, const PlyHeader& header) {
  const auto is_vertex = [](const PlyElement& element) { return element.name == "vertex"; };
  if (std::count_if(header.elements.begin(), header.elements.end(), is_vertex) != 1) {
    reader.FailAtLine(
        "the header must announce the element 'vertex' once; without it the file has no points");
  }
  return *std::find_if(header.elements.begin(), header.elements.end(), is_vertex);
}

/// Before memory is taken for what the header announces.
void CheckThatDataFollow(const StreamReader& reader, PlyFormat format, const PlyElement& element) {
  const std::uint64_t smallest = SmallestRecord(format, element);
  if (smallest == 0 && element.count > 0) {
    Fail("{}:{}: the element {} has no properties; remove it", reader.name(), element.line,
         Quoted(element.name));
  }
  // One byte more, because the last line of a text need not have an end.
  const std::uint64_t bytes = reader.Remaining().value_or(UINT64_MAX - 1) + 1;
  if (smallest == 0 || element.count <= bytes / smallest) return;
  Fail("{}:{}: the header announces {} times {}, but only {} bytes follow; the file is truncated",
       reader.name(), element.line, element.count, Quoted(element.name), bytes - 1);
}

PointFields FindFields(const StreamReader& reader, const PlyElement& vertices) {
  std::vector<std::string> names;
  for (const PlyProperty& property : vertices.properties) {
    // A list cannot be a coordinate, whatever its name.
    names.push_back(property.list_count ? "" : property.name);
  }
  return FindPointFields(names, reader);
}

void GatherRows(StreamReader& reader, PlyFormat format, const PlyElement& vertices, PointGatherer& points) {
  PlyRowReader rows(reader, format, vertices);
  for (std::uint64_t row = 0; row < vertices.count; ++row) {
    const std::uint64_t byte = reader.offset();
    const auto defect = points.AddRow(rows.Next());
    if (!defect) continue;
    if (format == PlyFormat::kAscii) reader.FailAtLine("the vertex {}; remove it", defect->problem);
    reader.FailAtByte(byte, "vertex {} {}; remove it", row + 1, defect->problem);
  }
}

PointCloud ReadVertices(StreamReader& reader, PlyFormat format, const PlyElement& vertices) {
  PointGatherer points(FindFields(reader, vertices), PointGatherer::NanPolicy::kDefect);
  // Of a pipe nobody knows whether it holds what its header announces.
  const std::uint64_t most =
      reader.Remaining() ? vertices.count : std::min<std::uint64_t>(vertices.count, 1 << 16);
  points.Reserve(static_cast<std::size_t>(most));
  RecordLayout layout;
  layout.big_endian = format == PlyFormat::kBinaryBigEndian;
  for (const PlyProperty& property : vertices.properties) layout.Append(property.type);
  const bool in_blocks =
      format != PlyFormat::kAscii && !vertices.has_lists() && layout.stride <= StreamReader::kChunkSize;
  if (in_blocks) {
    GatherRecords(reader, layout, vertices.count, points);
  } else {
    GatherRows(reader, format, vertices, points);
  }
  return points.TakeCloud();
}

void SkipElement(StreamReader& reader, PlyFormat format, const PlyElement& element) {
  if (format != PlyFormat::kAscii && !element.has_lists()) {
    SkipBytes(reader, element.count * element.stride());  // CheckThatDataFollow has excluded an overflow
    return;
  }
  PlyRowReader rows(reader, format, element);
  for (std::uint64_t row = 0; row < element.count; ++row) rows.Next();
}

}  // namespace

PointCloud ReadPly(std::istream& in, const std::string& name) {
  StreamReader reader(in, name);
  const PlyHeader header = ReadPlyHeader(reader);
  const PlyElement& vertices = RequireVertices(reader, header);
  PointCloud cloud;
  for (const PlyElement& element : header.elements) {
    CheckThatDataFollow(reader, header.format, element);
    if (&element == &vertices) {
      cloud = ReadVertices(reader, header.format, element);
    } else {
      SkipElement(reader, header.format, element);
    }
  }
  if (header.format == PlyFormat::kAscii) {
    CheckOnlyBlankLinesFollow(reader, "correct the counts of the header");
  } else {
    CheckOnlyPaddingFollows(reader);
  }
  return cloud;
}

}  // namespace ariadne::slam
