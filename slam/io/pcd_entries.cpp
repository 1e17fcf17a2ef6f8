#include "slam/io/pcd_entries.h"

#include <algorithm>
#include <array>
#include <utility>

#include "slam/io/row_parser.h"

namespace ariadne::slam {
namespace {

bool IsKeyword(std::string_view word) {
  constexpr std::array<std::string_view, 10> kKeywords{"VERSION", "FIELDS", "SIZE",      "TYPE",   "COUNT",
                                                       "WIDTH",   "HEIGHT", "VIEWPOINT", "POINTS", "DATA"};
  return std::find(kKeywords.begin(), kKeywords.end(), word) != kKeywords.end();
}

}  // namespace

std::vector<std::uint64_t> PcdEntry::Counts(std::size_t expected) const {
  CheckSize(expected);
  std::vector<std::uint64_t> counts;
  for (const std::string& value : values) {
    const std::optional<std::uint64_t> count = ParseCount(value);
    if (!count) Fail("{}: {} cannot be {}; it must be a whole number", place, keyword, Quoted(value));
    counts.push_back(*count);
  }
  return counts;
}

void PcdEntry::CheckSize(std::size_t expected) const {
  if (values.size() == expected) return;
  Fail("{}: {} has {} values, expected {}", place, keyword, values.size(), expected);
}

PcdEntries::PcdEntries(StreamReader& reader) {
  while (Find("DATA") == nullptr) {
    const std::optional<std::string_view> line = reader.NextLine();
    if (!line) {
      Fail("{}:{}: the PCD header ends before DATA; the file is truncated", reader.name(),
           reader.line() + 1);
    }
    const std::vector<std::string_view> words = SplitAtBlanks(*line);
    if (words.empty() || words.front().starts_with('#')) continue;
    if (!IsKeyword(words.front())) reader.FailAtLine("{} is not a line of a PCD header", Quoted(*line));
    end_ = fmt::format("{}:{}", reader.name(), reader.line());
    PcdEntry entry{std::string(words.front()), end_, {words.begin() + 1, words.end()}};
    const bool first = entries_.emplace(words.front(), std::move(entry)).second;
    if (!first) reader.FailAtLine("{} stands in the header for the second time; remove one", words.front());
  }
}

const PcdEntry* PcdEntries::Find(std::string_view keyword) const {
  const auto found = entries_.find(keyword);
  return found == entries_.end() ? nullptr : &found->second;
}

const PcdEntry& PcdEntries::Require(std::string_view keyword) const {
  const PcdEntry* const entry = Find(keyword);
  if (entry == nullptr) Fail("{}: the PCD header has no line {}", end_, keyword);
  return *entry;
}

}  // namespace ariadne::slam
