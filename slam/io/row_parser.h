#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "slam/io/stream_reader.h"

namespace ariadne::slam {

/// What separates words.
inline constexpr std::string_view kBlanks = " \t";

/// Turns lines into rows of numbers.
class RowParser {
 public:
  /// Numbers are separated by blanks, or by one of the `delimiters` with or without blanks around it.
  /// The reader lends its place in the file to the messages.
  explicit RowParser(const StreamReader& reader, std::string_view delimiters = "")
      : reader_(reader), delimiters_(delimiters) {}

  /// The numbers of the line that the reader returned last (or a part of it), valid until the next call.
  /// Error where something is not a number as a whole ("1.0abc", "1,0") or does not fit a double.
  /// "nan" and "inf" are numbers here.
  std::span<const double> Parse(std::string_view line);

 private:
  const char* ParseNumber(const char* at, const char* end);
  [[noreturn]] void FailAtToken(const char* at, const char* end, std::string_view problem) const;
  const char* SkipBlanks(const char* at, const char* end) const;
  bool IsDelimiter(char c) const { return delimiters_.find(c) != std::string_view::npos; }

  const StreamReader& reader_;
  std::string_view delimiters_;
  std::vector<double> row_;
};

/// A word that is a number as a whole.
std::optional<double> ParseNumber(std::string_view word);

/// The line cut at its blanks.
std::vector<std::string_view> SplitAtBlanks(std::string_view line);

/// A word that is a whole number from 0 to 2^64 - 1, and nothing else.
std::optional<std::uint64_t> ParseCount(std::string_view word);

/// Nothing but blanks.
bool IsBlankLine(std::string_view line);

/// Error at the first line of the rest of the text that is not blank; `remedy` ends its sentence.
void CheckOnlyBlankLinesFollow(StreamReader& reader, std::string_view remedy);

}  // namespace ariadne::slam
