#include "slam/io/cloud_io.h"

#include <string>

#include "slam/base/error.h"
#include "slam/io/file.h"
#include "slam/io/kitti.h"
#include "slam/io/pcd.h"
#include "slam/io/ply.h"
#include "slam/io/uos_cloud.h"
#include "slam/io/xyz.h"
#include "slam/scan/slices.h"

namespace ariadne::slam {
namespace {

namespace fs = std::filesystem;

CloudFile Read(std::istream& in, const std::string& name, CloudFormat format) {
  switch (format) {
    case CloudFormat::kUos:
      return {ReadUosCloud(in, name)};
    case CloudFormat::kXyz:
      return {ReadXyz(in, name)};
    case CloudFormat::kPly:
      return {ReadPly(in, name)};
    case CloudFormat::kPcd:
      return ReadPcd(in, name);
    case CloudFormat::kKitti:
      break;
  }
  return {ReadKitti(in, name)};
}

void Write(std::ostream& out, const PointCloud& cloud, CloudFormat format, CloudEncoding encoding) {
  switch (format) {
    case CloudFormat::kUos:
      return WriteUosCloud(out, cloud);
    case CloudFormat::kXyz:
      return WriteXyz(out, cloud);
    case CloudFormat::kPly:
      return WritePly(out, cloud,
                      encoding == CloudEncoding::kAscii ? PlyEncoding::kAscii : PlyEncoding::kBinary);
    case CloudFormat::kPcd:
      if (encoding == CloudEncoding::kBinaryCompressed) {
        return WritePcd(out, cloud, PcdEncoding::kBinaryCompressed);
      }
      return WritePcd(out, cloud,
                      encoding == CloudEncoding::kAscii ? PcdEncoding::kAscii : PcdEncoding::kBinary);
    case CloudFormat::kKitti:
      return WriteKitti(out, cloud);
  }
}

}  // namespace

CloudFile ReadCloud(const fs::path& path, CloudFormat format) {
  CloudFile file =
      ReadFile(path, [&](std::istream& in, const std::string& name) { return Read(in, name, format); });
  if (!file.cloud.organized()) file.cloud.slice_begin = InferSlices(file.cloud.positions);
  return file;
}

CloudFile ReadCloud(const fs::path& path) { return ReadCloud(path, FormatFromPath(path)); }

void WriteCloud(const fs::path& path, const PointCloud& cloud, std::optional<CloudEncoding> encoding) {
  const CloudFormat format = FormatFromPath(path);
  const CloudEncoding chosen = encoding.value_or(DefaultEncoding(format));
  if (!CanEncode(format, chosen)) {
    Fail("{}: the format {} has no such encoding; leave the choice to the format", path.string(),
         NameOf(format));
  }
  WriteFileAtomically(path, [&](std::ostream& out) { Write(out, cloud, format, chosen); });
}

}  // namespace ariadne::slam
