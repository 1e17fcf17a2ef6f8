#include "slam/io/ply_header.h"

#include <algorithm>
#include <span>
#include <string_view>

#include "slam/io/row_parser.h"

namespace ariadne::slam {
namespace {

using HeaderWords = std::span<const std::string_view>;

std::optional<ScalarType> ParseType(std::string_view word) {
  if (word == "char" || word == "int8") return ScalarType::kInt8;
  if (word == "uchar" || word == "uint8") return ScalarType::kUint8;
  if (word == "short" || word == "int16") return ScalarType::kInt16;
  if (word == "ushort" || word == "uint16") return ScalarType::kUint16;
  if (word == "int" || word == "int32") return ScalarType::kInt32;
  if (word == "uint" || word == "uint32") return ScalarType::kUint32;
  if (word == "float" || word == "float32") return ScalarType::kFloat32;
  if (word == "double" || word == "float64") return ScalarType::kFloat64;
  return std::nullopt;
}

ScalarType RequireType(const StreamReader& reader, std::string_view word) {
  const std::optional<ScalarType> type = ParseType(word);
  if (!type) {
    reader.FailAtLine("{} is not a type of PLY; use char, uchar, ..., float or double", Quoted(word));
  }
  return *type;
}

PlyFormat ParseFormat(const StreamReader& reader, HeaderWords words) {
  const std::string_view format = words.size() == 3 && words[2] == "1.0" ? words[1] : "";
  if (format == "ascii") return PlyFormat::kAscii;
  if (format == "binary_little_endian") return PlyFormat::kBinaryLittleEndian;
  if (format == "binary_big_endian") return PlyFormat::kBinaryBigEndian;
  reader.FailAtLine("expected 'format ascii 1.0', binary_little_endian or binary_big_endian");
}

PlyElement ParseElement(const StreamReader& reader, HeaderWords words) {
  if (words.size() != 3) reader.FailAtLine("expected 'element <name> <count>'");
  const std::optional<std::uint64_t> count = ParseCount(words[2]);
  if (!count) reader.FailAtLine("{} is not a number of elements", Quoted(words[2]));
  PlyElement element;
  element.name = words[1];
  element.count = *count;
  element.line = reader.line();
  return element;
}

PlyProperty ParseProperty(const StreamReader& reader, HeaderWords words) {
  PlyProperty property;
  property.name = words.back();
  if (words.size() == 3) {
    property.type = RequireType(reader, words[1]);
  } else if (words.size() == 5 && words[1] == "list") {
    property.list_count = RequireType(reader, words[2]);
    property.type = RequireType(reader, words[3]);
    const bool whole =
        *property.list_count != ScalarType::kFloat32 && *property.list_count != ScalarType::kFloat64;
    if (!whole) reader.FailAtLine("the length of a list must be an integer, not {}", words[2]);
  } else {
    reader.FailAtLine("expected 'property <type> <name>' or 'property list <type> <type> <name>'");
  }
  return property;
}

}  // namespace

bool PlyElement::has_lists() const {
  return std::any_of(properties.begin(), properties.end(),
                     [](const PlyProperty& property) { return property.list_count.has_value(); });
}

std::size_t PlyElement::stride() const {
  std::size_t stride = 0;
  for (const PlyProperty& property : properties) stride += SizeOf(property.type);
  return stride;
}

PlyHeader ReadPlyHeader(StreamReader& reader) {
  if (reader.NextLine() != "ply") {
    Fail("{}:1: is not a PLY file; the first line must be 'ply'", reader.name());
  }
  PlyHeader header;
  std::optional<PlyFormat> format;
  while (const std::optional<std::string_view> line = reader.NextLine()) {
    const std::vector<std::string_view> words = SplitAtBlanks(*line);
    const std::string_view keyword = words.empty() ? "" : words.front();
    if (keyword == "comment" || keyword == "obj_info") continue;
    if (keyword == "end_header") {
      if (!format) reader.FailAtLine("the header has no line 'format ...'");
      header.format = *format;
      return header;
    }
    if (keyword == "format") {
      format = ParseFormat(reader, words);
    } else if (keyword == "element") {
      header.elements.push_back(ParseElement(reader, words));
    } else if (keyword == "property" && !header.elements.empty()) {
      header.elements.back().properties.push_back(ParseProperty(reader, words));
    } else {
      reader.FailAtLine("{} is not a line of a PLY header", Quoted(*line));
    }
  }
  Fail("{}:{}: the file ends before 'end_header'; it is truncated", reader.name(), reader.line() + 1);
}

}  // namespace ariadne::slam
