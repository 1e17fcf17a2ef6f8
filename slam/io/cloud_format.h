#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

namespace ariadne::slam {

enum class CloudFormat { kUos, kXyz, kPly, kPcd, kKitti };

/// "uos", "xyz", "ply", "pcd" or "kitti"; Error for any other name.
CloudFormat FormatFromName(std::string_view name);
std::string_view NameOf(CloudFormat format);

/// By the extension: .3d; .xyz, .xyzr, .txt, .asc, .csv; .ply; .pcd; .bin. Nothing for any other.
std::optional<CloudFormat> FormatFromExtension(const std::filesystem::path& path);
/// The same, with an Error for any other.
CloudFormat FormatFromPath(const std::filesystem::path& path);

enum class CloudEncoding { kAscii, kBinary, kBinaryCompressed };

/// "ascii", "binary" or "binary_compressed"; Error for any other name.
CloudEncoding EncodingFromName(std::string_view name);

/// How a format is written where nothing else is asked for, and what can be asked for.
CloudEncoding DefaultEncoding(CloudFormat format);
bool CanEncode(CloudFormat format, CloudEncoding encoding);

}  // namespace ariadne::slam
