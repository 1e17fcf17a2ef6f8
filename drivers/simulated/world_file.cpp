#include "drivers/simulated/world_file.h"

#include <filesystem>
#include <fstream>
#include <sstream>

#include "drivers/simulated/world_reader.h"
#include "slam/base/error.h"

namespace ariadne::drivers {

World ParseWorld(const std::string& text, const std::string& name_for_errors) {
  try {
    const std::vector<YAML::Node> documents = YAML::LoadAll(text);
    if (documents.size() != 1)
      Fail("{}: a world is one YAML document, not {}", name_for_errors, documents.size());
    return WorldReader(name_for_errors).Read(documents.front());
  } catch (const YAML::Exception& e) {
    Fail("{}:{}: not valid YAML: {}", name_for_errors, e.mark.line + 1, e.msg);
  }
}

World ReadWorldFile(const std::string& path) {
  std::error_code ignored;  // what cannot be asked for cannot be opened either
  if (std::filesystem::is_directory(path, ignored)) Fail("{}: is a folder, not a world", path);
  std::ifstream in(path);
  if (!in) Fail("{}: cannot open the world", path);
  std::stringstream text;
  text << in.rdbuf();
  if (in.bad()) Fail("{}: cannot read the world", path);
  World world = ParseWorld(text.str(), path);
  if (world.name.empty()) world.name = std::filesystem::path(path).stem().string();
  return world;
}

}  // namespace ariadne::drivers
