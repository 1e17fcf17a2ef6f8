#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ariadne::slam {

/// The length of a layer's name: DXF of release 12 takes no more.
inline constexpr std::size_t kMaxLayerName = 31;

/// Whether every format takes the name: letters, digits, '_' and '-', and at most kMaxLayerName of them.
bool IsLayerName(std::string_view name);

/// A layer's name for each of the things: the prefix and its name, with '_' for what a layer's name cannot
/// hold, cut where it is long, and numbered where two would be alike to a program for which case does not
/// count. The prefix is a layer's name itself, of at most 16 characters.
std::vector<std::string> LayerNames(std::string_view prefix, std::span<const std::string> names);

}  // namespace ariadne::slam
