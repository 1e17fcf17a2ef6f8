#pragma once

#include <string>

#include "drivers/simulated/mesh_world.h"
#include "drivers/simulated/plan_world.h"
#include "drivers/simulated/world.h"

namespace ariadne::drivers {

/// What the kinds of sources that are not complete worlds leave open.
struct WorldOptions {
  PlanOptions plan;
  MeshOptions mesh;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("plan", self.plan, "for floor plans: .json");
    visit("mesh", self.mesh, "for meshes: .dae, .obj, .stl, .ply and whatever else assimp reads");
  }
};

/// A world by its source: builtin:NAME, a description (.yaml), a floor plan (.json), or a mesh. An Error
/// with file and place, or with the names there are.
World LoadWorld(const std::string& source, const WorldOptions& options = {});

}  // namespace ariadne::drivers
