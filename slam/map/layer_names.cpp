#include "slam/map/layer_names.h"

#include <algorithm>
#include <set>

#include "slam/base/error.h"

namespace ariadne::slam {
namespace {

constexpr std::size_t kMaxPrefix = 16;

bool IsLetterOrDigit(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

bool Fits(char c) { return IsLetterOrDigit(c) || c == '_' || c == '-'; }

std::string InUpperCase(std::string name) {
  for (char& c : name) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  }
  return name;
}

/// A name and a tail that must not be cut off.
std::string Joined(const std::string& name, const std::string& tail) {
  return name.substr(0, kMaxLayerName - tail.size()) + tail;
}

}  // namespace

bool IsLayerName(std::string_view name) {
  return !name.empty() && name.size() <= kMaxLayerName && std::ranges::all_of(name, Fits);
}

std::vector<std::string> LayerNames(std::string_view prefix, std::span<const std::string> names) {
  if (!IsLayerName(prefix) || prefix.size() > kMaxPrefix) {
    Fail("'{}' cannot begin the names of layers; use up to {} letters, digits, '_' and '-'", prefix,
         kMaxPrefix);
  }
  std::set<std::string> taken;
  std::vector<std::string> layers;
  for (const std::string& name : names) {
    std::string whole = std::string(prefix) + name;
    std::ranges::replace_if(
        whole, [](char c) { return !Fits(c); }, '_');
    std::string layer = Joined(whole, "");
    for (int number = 2; !taken.insert(InUpperCase(layer)).second; ++number) {
      layer = Joined(whole, fmt::format("-{}", number));
    }
    layers.push_back(std::move(layer));
  }
  return layers;
}

}  // namespace ariadne::slam
