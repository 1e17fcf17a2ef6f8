#include "slam/io/row_parser.h"

#include <algorithm>
#include <charconv>
#include <system_error>

namespace ariadne::slam {
namespace {

bool IsBlank(char c) { return c == ' ' || c == '\t'; }

}  // namespace

std::span<const double> RowParser::Parse(std::string_view line) {
  row_.clear();
  const char* const end = line.data() + line.size();
  const char* at = SkipBlanks(line.data(), end);
  while (at != end) {
    at = SkipBlanks(ParseNumber(at, end), end);
    if (at == end || !IsDelimiter(*at)) continue;
    at = SkipBlanks(at + 1, end);
    if (at == end) reader_.FailAtLine("a number is missing after the last separator; complete the line");
  }
  return row_;
}

const char* RowParser::ParseNumber(const char* at, const char* end) {
  const bool plus = *at == '+' && end - at > 1 && at[1] != '-';
  const char* const digits = plus ? at + 1 : at;  // from_chars knows no plus
  double number = 0.0;
  const auto [after, error] = std::from_chars(digits, end, number);
  const bool whole = after == end || IsBlank(*after) || IsDelimiter(*after);
  if (error == std::errc::invalid_argument || !whole) FailAtToken(at, end, "is not a number");
  if (error != std::errc()) FailAtToken(at, end, "is outside the range of a double");
  row_.push_back(number);
  return after;
}

void RowParser::FailAtToken(const char* at, const char* end, std::string_view problem) const {
  const char* const after = std::find_if(at, end, [&](char c) { return IsBlank(c) || IsDelimiter(c); });
  reader_.FailAtLine("{} {}", Quoted(std::string_view(at, static_cast<std::size_t>(after - at))), problem);
}

const char* RowParser::SkipBlanks(const char* at, const char* end) const {
  while (at != end && IsBlank(*at)) ++at;
  return at;
}

std::optional<double> ParseNumber(std::string_view word) {
  double number = 0.0;
  const auto [after, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error != std::errc() || after != word.data() + word.size()) return std::nullopt;
  return number;
}

std::vector<std::string_view> SplitAtBlanks(std::string_view line) {
  std::vector<std::string_view> words;
  std::size_t begin = line.find_first_not_of(kBlanks);
  while (begin != std::string_view::npos) {
    const std::size_t end = std::min(line.find_first_of(kBlanks, begin), line.size());
    words.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(kBlanks, end);
  }
  return words;
}

std::optional<std::uint64_t> ParseCount(std::string_view word) {
  std::uint64_t count = 0;
  const auto [after, error] = std::from_chars(word.data(), word.data() + word.size(), count);
  if (error != std::errc() || after != word.data() + word.size()) return std::nullopt;
  return count;
}

bool IsBlankLine(std::string_view line) {
  return line.find_first_not_of(kBlanks) == std::string_view::npos;
}

void CheckOnlyBlankLinesFollow(StreamReader& reader, std::string_view remedy) {
  while (const std::optional<std::string_view> line = reader.NextLine()) {
    if (!IsBlankLine(*line)) {
      reader.FailAtLine("found {} after the end of the data; {}", Quoted(*line), remedy);
    }
  }
}

}  // namespace ariadne::slam
