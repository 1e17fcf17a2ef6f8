#pragma once

#include <filesystem>
#include <string>

namespace ariadne::experiments {

/// The path with $ARIADNE_DATA replaced by the environment's value, or by ../shared/data where it has none.
std::filesystem::path ExpandDataPath(const std::string& path);

}  // namespace ariadne::experiments
