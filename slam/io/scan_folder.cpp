#include "slam/io/scan_folder.h"

#include "slam/base/error.h"
#include "slam/io/initial_poses.h"
#include "slam/io/scan_list.h"

namespace ariadne::slam {
namespace {

/// The index after the last scan to read.
std::size_t CheckedEnd(const ScanList& list, const ScanFolderOptions& options) {
  const std::size_t last = options.last.value_or(list.scans.size() - 1);
  if (options.first > last || last >= list.scans.size()) {
    Fail("{}: cannot read scans {} to {}; the folder has scans 0 to {}", list.folder.string(),
         options.first, last, list.scans.size() - 1);
  }
  return last + 1;
}

std::string PoseNote(const std::optional<InitialPoses>& poses) {
  if (!poses) return "no poses were found beside the scans: all start from identity";
  return "initial poses are from " + poses->source;
}

}  // namespace

ScanFolder ReadScanFolder(const std::filesystem::path& folder, const ScanFolderOptions& options) {
  const ScanList list = ListScans(folder, options.format);
  const std::size_t end = CheckedEnd(list, options);
  const std::optional<InitialPoses> poses = ReadInitialPoses(list, options.poses);
  ScanFolder read;
  read.notes.push_back(PoseNote(poses));
  for (std::size_t i = options.first; i < end; ++i) {
    const ScanFile& scan = list.scans[i];
    if (options.on_progress) options.on_progress(scan.name, i - options.first, end - options.first);
    CloudFile file = ReadCloud(scan.path, list.format);
    if (file.dropped > 0) {
      read.notes.push_back(
          fmt::format("{}: {} points without a measurement were dropped", scan.name, file.dropped));
    }
    read.scans.push_back({scan.name, std::move(file.cloud), poses ? poses->T_map_laser[i] : Pose3()});
  }
  return read;
}

}  // namespace ariadne::slam
