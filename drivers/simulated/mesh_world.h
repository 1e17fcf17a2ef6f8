#pragma once

#include <array>
#include <string>

#include "drivers/simulated/world.h"
#include "slam/base/options.h"

namespace ariadne::drivers {

/// Which axis of a mesh file points up.
enum class UpAxis { kFile, kX, kY, kZ };

/// What a mesh file does not say, or says wrongly.
struct MeshOptions {
  double scale = 1.0;
  UpAxis up = UpAxis::kFile;
  double reflectance = 0.6;
  bool floor = true;
  double floor_height = 0.0;
  double start_x = 0.0;
  double start_y = 0.0;
  double start_heading = 0.0;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("scale", self.scale, Unit(""), Range{1e-6, 1e6},
          "makes metres of what is read: 0.001 for an STL in millimetres; COLLADA's own unit is honoured "
          "before");
    visit("up", self.up, "the axis that points up; file: what it says, z where it says nothing");
    visit("reflectance", self.reflectance, Unit(""), Range{0.0, 1.0},
          "of all surfaces: colours do not tell it at 905 nm");
    visit("floor", self.floor,
          "lay a floor at z = 0 under everything: models of buildings are often without");
    visit("floor_height", self.floor_height, Unit("m"), Range{-1e6, 1e6},
          "in the file, of what becomes z = 0: where the robot drives");
    visit("start_x", self.start_x, Unit("m"), Range{-1e6, 1e6}, "where the robot starts");
    visit("start_y", self.start_y, Unit("m"), Range{-1e6, 1e6}, "where the robot starts");
    visit("start_heading", self.start_heading, Unit("rad"), Range{-7.0, 7.0},
          "where the robot looks at first");
  }
};

/// Whether a file name with this extension (".dae") is a mesh that can be read.
bool IsMeshExtension(const std::string& extension);

/// A world of any mesh that assimp reads; each of its nodes with triangles becomes a body in the map frame.
World ReadMeshWorld(const std::string& path, const MeshOptions& options = {});

}  // namespace ariadne::drivers

template <>
struct ariadne::EnumNames<ariadne::drivers::UpAxis> {
  static constexpr std::array<std::string_view, 4> value = {"file", "x", "y", "z"};
};
