#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "slam/io/stream_reader.h"

namespace ariadne::slam {

/// A line of a PCD header: a keyword and its values.
struct PcdEntry {
  std::string keyword;
  std::string place;  // "file:line", for messages
  std::vector<std::string> values;

  /// The values as whole numbers from 0 on; Error unless these are `expected` numbers.
  std::vector<std::uint64_t> Counts(std::size_t expected) const;
  /// Error unless there are `expected` values.
  void CheckSize(std::size_t expected) const;
};

/// The lines of a PCD header by keyword.
class PcdEntries {
 public:
  /// Reads up to and with the line DATA. Error for keywords that PCD does not have, or that stand twice.
  explicit PcdEntries(StreamReader& reader);

  const PcdEntry* Find(std::string_view keyword) const;
  /// Error where there is none.
  const PcdEntry& Require(std::string_view keyword) const;

 private:
  std::string end_;  // "file:line" of DATA
  std::map<std::string, PcdEntry, std::less<>> entries_;
};

}  // namespace ariadne::slam
