#pragma once

#include <map>
#include <string>
#include <utility>

#include "drivers/simulated/thing.h"
#include "drivers/simulated/world.h"
#include "drivers/simulated/yaml_fields.h"

namespace ariadne::drivers {

/// Makes a world of the YAML of one file.
class WorldReader {
 public:
  explicit WorldReader(std::string file) : file_(std::move(file)) {}

  World Read(const YAML::Node& root);

 private:
  /// Where the things of a list go.
  struct Place {
    slam::Pose3 T_map_list;
    int depth = 0;  // of groups in groups
  };

  void ReadMaterials(YamlFields& fields);
  void ReadThings(const std::vector<YAML::Node>& things, const Place& place);
  void ReadThing(const std::string& kind, YamlFields& fields, const Place& place);
  void ReadGroup(YamlFields& fields, const Place& place);
  slam::Pose3 ReadPose(YamlFields& fields) const;
  Motion ReadPath(YamlFields& fields) const;
  void AddBodies(const std::string& name, Thing thing, const Motion& motion, const YamlFields& fields);
  double ReflectanceOf(const std::string& material, const YamlFields& fields) const;

  std::string file_;
  World world_;
  double height_ = 2.7;
  std::size_t triangles_ = 0;
  int things_ = 0;
  std::map<std::string, double> materials_;
  std::map<std::string, std::vector<YAML::Node>> groups_;
  std::map<std::string, int> counts_;  // of things of a kind, to name them
};

}  // namespace ariadne::drivers
