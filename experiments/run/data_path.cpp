#include "experiments/run/data_path.h"

#include <cstdlib>

#include "slam/base/error.h"

namespace ariadne::experiments {

std::filesystem::path ExpandDataPath(const std::string& path) {
  constexpr std::string_view kVariable = "$ARIADNE_DATA";
  if (!path.starts_with(kVariable)) return path;
  const char* value = std::getenv("ARIADNE_DATA");
  const std::filesystem::path data = value != nullptr ? value : "../shared/data";
  if (!std::filesystem::exists(data)) {
    Fail(
        "{}: there is no folder {}; set the environment variable ARIADNE_DATA to the folder with the data "
        "sets",
        path, data.string());
  }
  return data.string() + path.substr(kVariable.size());
}

}  // namespace ariadne::experiments
