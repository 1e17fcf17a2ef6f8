#include "slam/io/point_fields.h"

#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <string_view>

namespace ariadne::slam {
namespace {

std::string LowerCase(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

/// The only field whose name is one of these.
std::optional<std::size_t> Find(std::span<const std::string> names,
                                std::initializer_list<std::string_view> wanted,
                                const StreamReader& reader) {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (std::find(wanted.begin(), wanted.end(), LowerCase(names[i])) == wanted.end()) continue;
    if (found) {
      reader.FailAtLine("the fields '{}' and '{}' mean the same; remove one", names[*found], names[i]);
    }
    found = i;
  }
  return found;
}

std::size_t FindCoordinate(std::span<const std::string> names, std::string_view wanted,
                           const StreamReader& reader) {
  const std::optional<std::size_t> found = Find(names, {wanted}, reader);
  if (!found) reader.FailAtLine("the points have no field '{}'; they need x, y and z", wanted);
  return *found;
}

}  // namespace

PointFields FindPointFields(std::span<const std::string> names, const StreamReader& reader) {
  PointFields fields;
  fields.position = {FindCoordinate(names, "x", reader), FindCoordinate(names, "y", reader),
                     FindCoordinate(names, "z", reader)};
  // A file may carry several of these; the first that is found in this order counts.
  for (const std::string name : {"reflectance", "reflectivity", "intensity", "remission"}) {
    if (!fields.reflectance) fields.reflectance = Find(names, {name, "scalar_" + name}, reader);
  }
  const auto nx = Find(names, {"nx", "normal_x"}, reader);
  const auto ny = Find(names, {"ny", "normal_y"}, reader);
  const auto nz = Find(names, {"nz", "normal_z"}, reader);
  if (nx && ny && nz) fields.normal = {*nx, *ny, *nz};
  return fields;
}

}  // namespace ariadne::slam
