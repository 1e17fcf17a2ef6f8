#include "slam/io/ply_rows.h"

#include <optional>
#include <string>
#include <string_view>

#include "slam/io/records.h"

namespace ariadne::slam {

std::span<const double> PlyRowReader::Next() {
  row_.clear();
  ++rows_;
  if (format_ == PlyFormat::kAscii) {
    ReadTextRow();
  } else {
    ReadBinaryRow();
  }
  return row_;
}

void PlyRowReader::ReadTextRow() {
  std::span<const double> numbers;
  while (numbers.empty()) {
    const std::optional<std::string_view> line = reader_.NextLine();
    if (!line) FailHere("the file ends");
    numbers = parser_.Parse(*line);
  }
  std::size_t next = 0;
  for (const PlyProperty& property : element_.properties) {
    if (next >= numbers.size()) FailHere("the line has too few numbers");
    row_.push_back(numbers[next++]);
    if (!property.list_count) continue;
    const std::uint64_t length = CheckedLength(row_.back());
    if (length > numbers.size() - next) FailHere("a list is longer than its line");
    next += static_cast<std::size_t>(length);
  }
  if (next != numbers.size()) FailHere("the line has too many numbers");
}

void PlyRowReader::ReadBinaryRow() {
  for (const PlyProperty& property : element_.properties) {
    row_.push_back(ReadScalar(property.list_count.value_or(property.type)));
    if (!property.list_count) continue;
    const std::uint64_t bytes = CheckedLength(row_.back()) * SizeOf(property.type);
    if (bytes > reader_.Remaining().value_or(bytes)) FailHere("a list runs over the end of the file");
    SkipBytes(reader_, bytes);
  }
}

double PlyRowReader::ReadScalar(ScalarType type) {
  const std::string_view bytes = reader_.NextBytes(SizeOf(type));
  if (bytes.size() < SizeOf(type)) FailHere("the file ends");
  double number = 0.0;
  CopyColumn({type, bytes.data(), bytes.size(), format_ == PlyFormat::kBinaryBigEndian}, {&number, 1}, 1);
  return number;
}

std::uint64_t PlyRowReader::CheckedLength(double length) const {
  // Integers up to 32 bits are exact here, and no list is longer.
  if (!(length >= 0.0 && length <= 4294967295.0)) FailHere("the length of a list is not a count");
  const auto whole = static_cast<std::uint64_t>(length);
  if (static_cast<double>(whole) != length) FailHere("the length of a list is not a count");
  return whole;
}

void PlyRowReader::FailHere(std::string_view problem) const {
  const std::string what =
      fmt::format("{} in {} {} of {}; the header (line {}) or the data is damaged", problem,
                  Quoted(element_.name), rows_, element_.count, element_.line);
  if (format_ == PlyFormat::kAscii) reader_.FailAtLine("{}", what);
  reader_.FailAtByte(reader_.offset(), "{}", what);
}

std::uint64_t SmallestRecord(PlyFormat format, const PlyElement& element) {
  if (format == PlyFormat::kAscii) return 2 * element.properties.size();  // a digit and what follows it
  std::uint64_t size = 0;
  for (const PlyProperty& property : element.properties) {
    size += SizeOf(property.list_count.value_or(property.type));
  }
  return size;
}

}  // namespace ariadne::slam
