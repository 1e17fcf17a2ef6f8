#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "slam/io/cloud_io.h"
#include "slam/scan/point_cloud.h"

namespace ariadne::slam {

struct ScanFolderOptions {
  std::optional<CloudFormat> format;           // none: told from the extensions
  std::optional<std::filesystem::path> poses;  // none: searched beside the scans (initial_poses.h)
  std::size_t first = 0;                       // index of the first scan to read, in natural order
  std::optional<std::size_t> last;             // index of the last scan to read; none: to the end
  /// Called before each scan with its name, how many are done, and how many there are.
  std::function<void(const std::string& name, std::size_t done, std::size_t total)> on_progress;
};

struct ScanFolder {
  std::vector<PosedCloud> scans;  // in natural order
  std::vector<std::string>
      notes;  // sentences that a user should see: where the poses come from, dropped points
};

/// Reads the scans of a folder with the first guesses of their poses (identity where there are none, which
/// a note says). Errors as those of ListScans, ReadInitialPoses and ReadCloud, and where the range of scans
/// is empty or beyond the end.
ScanFolder ReadScanFolder(const std::filesystem::path& folder, const ScanFolderOptions& options = {});

}  // namespace ariadne::slam
