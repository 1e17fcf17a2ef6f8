#include "drivers/simulated/yaml_fields.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

#include "slam/base/error.h"

namespace ariadne::drivers {
namespace {

/// Letters to insert, drop, replace, or swap with their neighbour.
std::size_t EditDistance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        d[i][j] = i + j;
        continue;
      }
      d[i][j] =
          std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  }
  return d[a.size()][b.size()];
}

}  // namespace

std::string NearestName(std::string_view name, const std::vector<std::string>& names) {
  const auto nearest = std::ranges::min_element(
      names, {}, [&](const std::string& known) { return EditDistance(name, known); });
  return nearest == names.end() ? "" : *nearest;
}

YamlFields::YamlFields(const YAML::Node& node, std::string file, const std::string& what)
    : node_(node), file_(std::move(file)) {
  if (!node_.IsMap()) Fail("{}: {} is a map of keys to values", Where(), what);
  std::set<std::string> seen;
  for (const auto& pair : node_) {
    if (!pair.first.IsScalar()) Fail("{}: a key is a word", WhereIs(pair.first));
    if (!seen.insert(pair.first.Scalar()).second) {
      Fail("{}: the key {} is repeated", WhereIs(pair.first), pair.first.Scalar());
    }
  }
}

std::string YamlFields::WhereIs(const YAML::Node& node) const {
  return fmt::format("{}:{}", file_, node.Mark().line + 1);
}

bool YamlFields::Has(std::string_view key) const {
  return std::any_of(node_.begin(), node_.end(),
                     [&](const auto& pair) { return pair.first.Scalar() == key; });
}

YAML::Node YamlFields::Take(std::string_view key) {
  Know(key);
  for (const auto& pair : node_) {
    if (pair.first.Scalar() == key) return pair.second;
  }
  Fail("{}: the key {} is missing", Where(), key);
}

double YamlFields::ToNumber(const YAML::Node& node, std::string_view what, Range range) const {
  const std::string text = node.IsScalar() ? node.Scalar() : "";
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || text.empty()) {
    Fail("{}: {} needs a number{}", WhereIs(node), what, node.IsScalar() ? ", not " + text : "");
  }
  if (!(number >= range.min && number <= range.max)) {
    Fail("{}: {} is {}, but must be in {} to {}", WhereIs(node), what, text, range.min, range.max);
  }
  return number;
}

double YamlFields::Number(std::string_view key, Range range) { return ToNumber(Take(key), key, range); }

double YamlFields::Whole(std::string_view key, Range range) {
  const YAML::Node node = Take(key);
  const double number = ToNumber(node, key, range);
  if (number != std::floor(number)) Fail("{}: {} needs a whole number, not {}", WhereIs(node), key, number);
  return number;
}

std::string YamlFields::Text(std::string_view key) {
  const YAML::Node node = Take(key);
  if (!node.IsScalar() || node.Scalar().empty()) Fail("{}: {} needs a name", WhereIs(node), key);
  return node.Scalar();
}

double YamlFields::NumberOr(double fallback, std::string_view key, Range range) {
  if (Has(key)) return Number(key, range);
  Know(key);
  return fallback;
}

std::string YamlFields::TextOr(const std::string& fallback, std::string_view key) {
  if (Has(key)) return Text(key);
  Know(key);
  return fallback;
}

Eigen::VectorXd YamlFields::ToNumbers(const YAML::Node& node, std::string_view what, std::size_t least,
                                      std::size_t most, Range range) const {
  if (!node.IsSequence() || node.size() < least || node.size() > most) {
    const std::string count =
        least == most ? fmt::format("{}", least) : fmt::format("{} to {}", least, most);
    Fail("{}: {} needs a list of {} numbers", WhereIs(node), what, count);
  }
  Eigen::VectorXd numbers(static_cast<Eigen::Index>(node.size()));
  for (std::size_t i = 0; i < node.size(); ++i) {
    numbers[static_cast<Eigen::Index>(i)] = ToNumber(node[i], what, range);
  }
  return numbers;
}

Eigen::VectorXd YamlFields::Numbers(std::string_view key, std::size_t least, std::size_t most,
                                    Range range) {
  return ToNumbers(Take(key), key, least, most, range);
}

std::vector<YAML::Node> YamlFields::List(std::string_view key) {
  if (!Has(key)) return Know(key), std::vector<YAML::Node>{};
  const YAML::Node node = Take(key);
  if (!node.IsSequence()) Fail("{}: {} needs a list", WhereIs(node), key);
  return {node.begin(), node.end()};
}

std::vector<std::pair<std::string, YAML::Node>> YamlFields::Entries(std::string_view key) {
  if (!Has(key)) return Know(key), std::vector<std::pair<std::string, YAML::Node>>{};
  const YAML::Node node = Take(key);
  YamlFields check(node, file_, std::string(key));
  std::vector<std::pair<std::string, YAML::Node>> entries;
  for (const auto& pair : node) entries.emplace_back(pair.first.Scalar(), pair.second);
  return entries;
}

std::size_t YamlFields::Choice(std::string_view key, const std::vector<std::string_view>& names) {
  const YAML::Node node = Take(key);
  const std::string text = node.IsScalar() ? node.Scalar() : "";
  const auto found = std::ranges::find(names, text);
  if (found == names.end()) {
    Fail("{}: {} is one of {}, not {}", WhereIs(node), key, fmt::join(names, ", "), text);
  }
  return static_cast<std::size_t>(found - names.begin());
}

void YamlFields::RequireAllTaken() const {
  for (const auto& pair : node_) {
    const std::string& key = pair.first.Scalar();
    if (std::ranges::find(known_, key) != known_.end()) continue;
    Fail("{}: unknown key {}; did you mean {}?", WhereIs(pair.first), key, NearestName(key, known_));
  }
}

}  // namespace ariadne::drivers
