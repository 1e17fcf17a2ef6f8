#pragma once

#include <functional>
#include <map>
#include <string>

#include "drivers/simulated/thing.h"
#include "drivers/simulated/yaml_fields.h"

namespace ariadne::drivers {

/// Where things may be: a coordinate [m].
inline constexpr Range kPlace{-1e6, 1e6};

/// How a kind of thing is made of its keys; `height` is that of the world's walls.
using ThingMaker = std::function<Thing(YamlFields& fields, double height)>;

/// All kinds that a world file may name, but for groups.
const std::map<std::string, ThingMaker>& ThingKinds();

/// Whether a kind says itself where it is (`from`, `to`), instead of by `at` and `turn`.
bool PlacesItself(const std::string& kind);

/// What the materials reflect at the scanner's 905 nm, unless the world says otherwise: share of light that
/// returns from a diffuse surface. Rounded from what manufacturers of laser scanners publish.
const std::map<std::string, double>& CommonMaterials();

}  // namespace ariadne::drivers
