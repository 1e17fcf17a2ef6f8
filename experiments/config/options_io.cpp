#include "experiments/config/options_io.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>

namespace ariadne::experiments {
namespace {

template <typename T>
T Parse(const OptionEntry& entry, std::string_view what) {
  T value{};
  const char* end = entry.value.data() + entry.value.size();
  const auto [stop, error] = std::from_chars(entry.value.data(), end, value);
  if (error != std::errc{} || stop != end) {
    Fail("{}: {} must be {}, not '{}'", entry.where, entry.key, what, entry.value);
  }
  return value;
}

/// How many letters must be changed, added or dropped to make one text of the other (Levenshtein).
std::size_t EditDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t change = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({change, row[j] + 1, diagonal + 1});
    }
  }
  return row[b.size()];
}

/// The most similar of the keys; one that ends alike ("max_distance" for "icp.max_distance") first.
std::string NearestKey(const std::string& key, const std::vector<std::string>& known_keys) {
  const auto distance = [&](const std::string& known) {
    const std::size_t dot = known.rfind('.');
    const std::size_t last = EditDistance(key.substr(key.rfind('.') + 1), known.substr(dot + 1));
    return std::pair(std::min(EditDistance(key, known), last + 1), known);
  };
  const auto nearest =
      std::min_element(known_keys.begin(), known_keys.end(),
                       [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
  return nearest == known_keys.end() ? "" : *nearest;
}

/// The only form of a YAML scalar in which a line break is a line break.
std::string DoubleQuoted(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      quoted += fmt::format("\\{}", c);
    } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) {
      quoted += fmt::format("\\x{:02x}", c);
    } else {
      quoted += c;
    }
  }
  return quoted + "\"";
}

}  // namespace

double ParseNumber(const OptionEntry& entry) {
  const double number = Parse<double>(entry, "a number");
  if (!std::isfinite(number))
    Fail("{}: {} must be a finite number, not '{}'", entry.where, entry.key, entry.value);
  return number;
}

long long ParseInteger(const OptionEntry& entry) { return Parse<long long>(entry, "a whole number"); }

bool ParseBool(const OptionEntry& entry) {
  if (entry.value == "true") return true;
  if (entry.value == "false") return false;
  Fail("{}: {} must be true or false, not '{}'", entry.where, entry.key, entry.value);
}

std::size_t ParseName(const OptionEntry& entry, const std::string_view* names, std::size_t count) {
  const auto found = std::find(names, names + count, entry.value);
  if (found == names + count) {
    Fail("{}: {} must be one of {}, not '{}'", entry.where, entry.key,
         fmt::join(names, names + count, ", "), entry.value);
  }
  return static_cast<std::size_t>(found - names);
}

void FailOutOfRange(const OptionEntry& entry, std::string_view unit, Range range) {
  Fail("{}: {} must be in {} to {}{}{}, not {}", entry.where, entry.key, range.min, range.max,
       unit.empty() ? "" : " ", unit, entry.value);
}

void RequireAllTaken(const OptionEntries& entries, const std::vector<std::string>& known_keys) {
  if (entries.entries().empty()) return;
  const OptionEntry& unknown = entries.entries().front();
  Fail("{}: unknown key {}; did you mean {}?", unknown.where, unknown.key,
       NearestKey(unknown.key, known_keys));
}

std::string ToYamlScalar(const std::string& text) {
  const auto is_control = [](unsigned char c) { return c < 0x20 || c == 0x7F; };
  if (std::any_of(text.begin(), text.end(), is_control)) return DoubleQuoted(text);
  const bool plain = !text.empty() && text.find_first_of(":#'\"{}[],&*!|>%@`\\\n\t") == std::string::npos &&
                     text.front() != ' ' && text.back() != ' ' && text.front() != '-' &&
                     text.front() != '?' && text != "~" && text != "null" && text != "Null" &&
                     text != "NULL";
  if (plain) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("''") : std::string(1, c);
  return quoted + "'";
}

}  // namespace ariadne::experiments
