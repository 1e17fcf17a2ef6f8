#include "slam/io/pose_lines.h"

#include <cmath>

namespace ariadne::slam {

std::optional<std::string_view> NextPoseLine(StreamReader& reader) {
  std::optional<std::size_t> blank;
  while (const std::optional<std::string_view> line = reader.NextLine()) {
    if (line->starts_with('#')) continue;
    if (IsBlankLine(*line)) {
      if (!blank) blank = reader.line();
      continue;
    }
    if (blank) {
      Fail("{}:{}: the line is empty where a pose is expected; remove the line", reader.name(), *blank);
    }
    return line;
  }
  return std::nullopt;
}

std::span<const double> ParseNumbers(const StreamReader& reader, RowParser& parser, std::string_view line,
                                     std::size_t count, std::string_view what) {
  const std::span<const double> numbers = parser.Parse(line);
  if (numbers.size() != count) {
    reader.FailAtLine("found {} numbers, expected {} ({})", numbers.size(), count, what);
  }
  for (const double number : numbers) {
    if (!std::isfinite(number)) reader.FailAtLine("a number is NaN or infinite ({})", what);
  }
  return numbers;
}

}  // namespace ariadne::slam
