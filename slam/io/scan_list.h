#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "slam/io/cloud_io.h"

namespace ariadne::slam {

/// A file with the points of one scan.
struct ScanFile {
  std::string name;  // of the file, without the extension: "scan003"
  std::filesystem::path path;
};

struct ScanList {
  std::filesystem::path folder;  // where they lie, which may be a subfolder of the one that was asked for
  CloudFormat format = CloudFormat::kUos;
  std::vector<ScanFile> scans;  // in natural order
};

/// Whether a name comes before another when numbers in it are compared as numbers: scan2 before scan10.
bool NaturallyBefore(std::string_view a, std::string_view b);

/// The scans in a folder, of one format, or of that given. A .txt file is a scan only if its name ends with
/// a number (scan000.txt), because texts beside the scans are called README or poses. Where the folder
/// holds no scans but exactly one of its subfolders does, these are listed. Error for no scans, or for
/// scans of several formats when none is given.
ScanList ListScans(const std::filesystem::path& folder, std::optional<CloudFormat> format = std::nullopt);

}  // namespace ariadne::slam
