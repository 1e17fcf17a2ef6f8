#include "slam/io/cloud_format.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <utility>

#include "slam/base/error.h"

namespace ariadne::slam {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::pair<std::string_view, CloudFormat>, 5> kNames{{{"uos", CloudFormat::kUos},
                                                                          {"xyz", CloudFormat::kXyz},
                                                                          {"ply", CloudFormat::kPly},
                                                                          {"pcd", CloudFormat::kPcd},
                                                                          {"kitti", CloudFormat::kKitti}}};

constexpr std::array<std::pair<std::string_view, CloudFormat>, 9> kExtensions{
    {{".3d", CloudFormat::kUos},
     {".xyz", CloudFormat::kXyz},
     {".xyzr", CloudFormat::kXyz},
     {".txt", CloudFormat::kXyz},
     {".asc", CloudFormat::kXyz},
     {".csv", CloudFormat::kXyz},
     {".ply", CloudFormat::kPly},
     {".pcd", CloudFormat::kPcd},
     {".bin", CloudFormat::kKitti}}};

constexpr std::array<std::pair<std::string_view, CloudEncoding>, 3> kEncodings{
    {{"ascii", CloudEncoding::kAscii},
     {"binary", CloudEncoding::kBinary},
     {"binary_compressed", CloudEncoding::kBinaryCompressed}}};

}  // namespace

CloudFormat FormatFromName(std::string_view name) {
  for (const auto& [known, format] : kNames) {
    if (name == known) return format;
  }
  Fail("there is no format of point clouds named '{}'; use uos, xyz, ply, pcd or kitti", name);
}

std::string_view NameOf(CloudFormat format) {
  const auto* const found =
      std::find_if(kNames.begin(), kNames.end(), [&](const auto& known) { return known.second == format; });
  return found->first;
}

std::optional<CloudFormat> FormatFromExtension(const fs::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (const auto& [known, format] : kExtensions) {
    if (extension == known) return format;
  }
  return std::nullopt;
}

CloudFormat FormatFromPath(const fs::path& path) {
  if (const auto format = FormatFromExtension(path)) return *format;
  Fail("{}: the extension does not tell the format; use .3d, .xyz, .txt, .asc, .csv, .ply, .pcd or .bin",
       path.string());
}

CloudEncoding EncodingFromName(std::string_view name) {
  for (const auto& [known, encoding] : kEncodings) {
    if (name == known) return encoding;
  }
  Fail("there is no encoding named '{}'; use ascii, binary or binary_compressed", name);
}

CloudEncoding DefaultEncoding(CloudFormat format) {
  const bool text = format == CloudFormat::kUos || format == CloudFormat::kXyz;
  return text ? CloudEncoding::kAscii : CloudEncoding::kBinary;
}

bool CanEncode(CloudFormat format, CloudEncoding encoding) {
  if (format == CloudFormat::kPcd) return true;
  if (format == CloudFormat::kPly) return encoding != CloudEncoding::kBinaryCompressed;
  return encoding == DefaultEncoding(format);
}

}  // namespace ariadne::slam
