#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "slam/io/row_parser.h"
#include "slam/io/stream_reader.h"

namespace ariadne::slam {

/// The next line of a file with a pose per line, where every line counts: `#` comments are skipped, but a
/// blank line before the end is an Error, for it may be a pose that was lost.
std::optional<std::string_view> NextPoseLine(StreamReader& reader);

/// Calls parse(line) for each pose and collects what it returns. Error where there is none.
template <typename Parse>
auto CollectLines(StreamReader& reader, const Parse& parse) {
  std::vector<decltype(parse(std::string_view()))> poses;
  while (const std::optional<std::string_view> line = NextPoseLine(reader)) poses.push_back(parse(*line));
  if (poses.empty()) Fail("{}: holds no poses; expected one per line", reader.name());
  return poses;
}

/// Exactly `count` finite numbers; else an Error that says `what` they should have been.
std::span<const double> ParseNumbers(const StreamReader& reader, RowParser& parser, std::string_view line,
                                     std::size_t count, std::string_view what);

}  // namespace ariadne::slam
