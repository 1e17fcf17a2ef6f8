#pragma once

#include <filesystem>
#include <optional>

#include "slam/io/cloud_file.h"
#include "slam/io/cloud_format.h"

namespace ariadne::slam {

/// Reads a cloud [m], x forward, y left, z up. Where the file does not tell its slices they are inferred.
/// Errors name the file and the line or byte.
CloudFile ReadCloud(const std::filesystem::path& path, CloudFormat format);
CloudFile ReadCloud(const std::filesystem::path& path);

/// Writes a cloud at once or not at all, in the format of the extension. Without an encoding, PLY and PCD
/// are binary; Error for an encoding that the format does not have.
void WriteCloud(const std::filesystem::path& path, const PointCloud& cloud,
                std::optional<CloudEncoding> encoding = std::nullopt);

}  // namespace ariadne::slam
