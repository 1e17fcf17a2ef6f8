#include "slam/io/pcd_header.h"

#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "slam/io/pcd_entries.h"
#include "slam/io/row_parser.h"

namespace ariadne::slam {
namespace {

ScalarType ScalarOf(const PcdEntry& types, std::string_view type, std::uint64_t size) {
  using enum ScalarType;
  constexpr std::array<std::pair<std::string_view, ScalarType>, 10> kTypes{{{"I1", kInt8},
                                                                            {"I2", kInt16},
                                                                            {"I4", kInt32},
                                                                            {"I8", kInt64},
                                                                            {"U1", kUint8},
                                                                            {"U2", kUint16},
                                                                            {"U4", kUint32},
                                                                            {"U8", kUint64},
                                                                            {"F4", kFloat32},
                                                                            {"F8", kFloat64}}};
  for (const auto& [name, scalar] : kTypes) {
    if (name == fmt::format("{}{}", type, size)) return scalar;
  }
  Fail("{}: there is no TYPE {} of SIZE {}; use F 4 or 8, I or U 1, 2, 4 or 8", types.place, Quoted(type),
       size);
}

void AddField(PcdHeader& header, const PcdEntry& fields, const std::string& name, ScalarType type,
              std::uint64_t count) {
  const std::uint64_t room = (StreamReader::kChunkSize - header.layout.stride) / SizeOf(type);
  if (count < 1 || count > room) {
    Fail("{}: the field {} cannot have COUNT {}", fields.place, Quoted(name), count);
  }
  for (std::uint64_t i = 0; i < count; ++i) {
    header.columns.push_back(count == 1 ? name : "");
    header.layout.Append(type);
  }
}

void ReadFields(const PcdEntries& entries, PcdHeader& header) {
  const PcdEntry& fields = entries.Require("FIELDS");
  const PcdEntry& types = entries.Require("TYPE");
  const std::size_t n = fields.values.size();
  types.CheckSize(n);
  const std::vector<std::uint64_t> sizes = entries.Require("SIZE").Counts(n);
  const PcdEntry* const count = entries.Find("COUNT");
  const auto counts = count != nullptr ? count->Counts(n) : std::vector<std::uint64_t>(n, 1);
  for (std::size_t f = 0; f < n; ++f) {
    AddField(header, fields, fields.values[f], ScalarOf(types, types.values[f], sizes[f]), counts[f]);
  }
}

void ReadCounts(const PcdEntries& entries, PcdHeader& header) {
  const PcdEntry& points = entries.Require("POINTS");
  header.points = points.Counts(1).front();
  header.points_place = points.place;
  header.width = entries.Require("WIDTH").Counts(1).front();
  header.height = entries.Require("HEIGHT").Counts(1).front();
  const bool overflow =
      header.height != 0 && header.width > std::numeric_limits<std::uint64_t>::max() / header.height;
  if (overflow || header.width * header.height != header.points) {
    Fail("{}: POINTS is {}, but WIDTH x HEIGHT is {} x {}; correct the header", points.place, header.points,
         header.width, header.height);
  }
}

/// Where the scanner stood, "tx ty tz qw qx qy qz".
void CheckViewpoint(const PcdEntry& viewpoint) {
  viewpoint.CheckSize(7);
  double squared_length = 0.0;
  for (std::size_t i = 0; i < viewpoint.values.size(); ++i) {
    const std::optional<double> number = ParseNumber(viewpoint.values[i]);
    if (!number || !std::isfinite(*number)) {
      Fail("{}: {} in VIEWPOINT is not a finite number", viewpoint.place, Quoted(viewpoint.values[i]));
    }
    if (i >= 3) squared_length += *number * *number;
  }
  if (!(std::abs(squared_length - 1.0) < 1e-2)) {
    Fail("{}: the quaternion of VIEWPOINT (its last four numbers) is not of unit length", viewpoint.place);
  }
}

PcdEncoding EncodingOf(const PcdEntry& data) {
  data.CheckSize(1);
  if (data.values.front() == "ascii") return PcdEncoding::kAscii;
  if (data.values.front() == "binary") return PcdEncoding::kBinary;
  if (data.values.front() == "binary_compressed") return PcdEncoding::kBinaryCompressed;
  Fail("{}: DATA is {}, expected ascii, binary or binary_compressed", data.place,
       Quoted(data.values.front()));
}

}  // namespace

PcdHeader ReadPcdHeader(StreamReader& reader) {
  const PcdEntries entries(reader);
  const PcdEntry& version = entries.Require("VERSION");
  version.CheckSize(1);
  if (version.values.front() != "0.7" && version.values.front() != ".7") {
    Fail("{}: the version is {}, expected 0.7", version.place, Quoted(version.values.front()));
  }
  PcdHeader header;
  ReadFields(entries, header);
  ReadCounts(entries, header);
  if (const PcdEntry* const viewpoint = entries.Find("VIEWPOINT")) CheckViewpoint(*viewpoint);
  header.encoding = EncodingOf(entries.Require("DATA"));
  return header;
}

}  // namespace ariadne::slam
