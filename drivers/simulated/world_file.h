#pragma once

#include <span>
#include <string>
#include <string_view>

#include "drivers/simulated/world.h"

namespace ariadne::drivers {

/// A world that is described in YAML, as drivers/simulated/worlds/robobench.yaml is:
///
///   start: [x, y, heading]       # m and degrees, like all of the file
///   height: 2.7                  # of walls and pillars that do not say theirs
///   materials: {name: reflectance}
///   groups: {name: [things]}     # to be placed several times
///   things:
///     - wall: {from: [x, y], to: [x, y], openings: [{at, width, top, hinge, angle}]}
///     - table: {at: [x, y], turn: 90}
///     - person: {path: [[t, x, y, heading], ...]}
///     - group: {of: name, at: [x, y], turn: 180}
///
/// Every thing may have `name`, `material` (of its main part) and `z`; kinds and their lengths are in
/// furniture.h, fittings.h and building.h. A damaged file is an Error with file and line.
World ReadWorldFile(const std::string& path);
World ParseWorld(const std::string& text, const std::string& name_for_errors);

/// The worlds that are part of the program, by name.
struct BuiltinWorld {
  std::string_view name;
  std::string_view yaml;
};
std::span<const BuiltinWorld> BuiltinWorlds();

}  // namespace ariadne::drivers
