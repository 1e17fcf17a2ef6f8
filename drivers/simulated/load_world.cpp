#include "drivers/simulated/load_world.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "drivers/simulated/world_file.h"
#include "slam/base/error.h"

namespace ariadne::drivers {
namespace {

constexpr std::string_view kBuiltin = "builtin:";

World LoadBuiltin(std::string_view name) {
  std::string names;
  for (const BuiltinWorld& world : BuiltinWorlds()) {
    if (world.name == name) return ParseWorld(std::string(world.yaml), fmt::format("{}{}", kBuiltin, name));
    names += fmt::format("{}{}", names.empty() ? "" : ", ", world.name);
  }
  Fail("{}{}: no world of that name is built in; there are {}", kBuiltin, name, names);
}

std::string ExtensionOf(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
  return extension;
}

}  // namespace

World LoadWorld(const std::string& source, const WorldOptions& options) {
  if (source.starts_with(kBuiltin)) return LoadBuiltin(std::string_view(source).substr(kBuiltin.size()));
  const std::string extension = ExtensionOf(source);
  if (extension == ".yaml" || extension == ".yml") return ReadWorldFile(source);
  if (extension == ".json") return ReadPlanWorld(source, options.plan);
  if (IsMeshExtension(extension)) return ReadMeshWorld(source, options.mesh);
  Fail(
      "{}: not a world: expected builtin:NAME, .yaml, a floor plan (.json) or a mesh (.dae, .obj, .stl, "
      ".ply)",
      source);
}

}  // namespace ariadne::drivers
