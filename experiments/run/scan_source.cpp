#include "experiments/run/scan_source.h"

#include <cstdlib>

#include "slam/base/error.h"
#include "slam/io/cloud_io.h"
#include "slam/io/initial_poses.h"
#include "slam/io/scan_list.h"

namespace ariadne::experiments {
namespace {

constexpr std::string_view kBuiltIn = "builtin:office";

}  // namespace

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

ScanSource::ScanSource(const InputOptions& options) {
  CheckOptions(options, "input.");
  if (options.folder == kBuiltIn) {
    OpenOffice(options.office);
  } else {
    OpenFolder(options);
  }
  Select(options);
}

void ScanSource::Select(const InputOptions& options) {
  const std::size_t count = entries_.size();
  const auto begin = static_cast<std::size_t>(options.first);
  const std::size_t end = options.last < 0 ? count : static_cast<std::size_t>(options.last) + 1;
  if (end > count || begin >= end) {
    Fail("{}: scans {} to {} were asked for (input.first, input.last), but there are 0 to {}",
         options.folder, options.first, options.last, count - 1);
  }
  entries_.erase(entries_.begin() + static_cast<std::ptrdiff_t>(end), entries_.end());
  entries_.erase(entries_.begin(), entries_.begin() + static_cast<std::ptrdiff_t>(begin));
}

void ScanSource::OpenOffice(const OfficeScanOptions& options) {
  const std::vector<slam::Pose3> truth = TrueLaserPoses(options);
  const std::vector<slam::Pose3> odometry = OdometryPoses(options);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    entries_.push_back({fmt::format("scan{:03}", i), i, odometry[i], truth[i], {}});
  }
  office_ = options;
  notes_.push_back(fmt::format("simulated office, seed {}: the true poses are known", options.seed));
}

void ScanSource::OpenFolder(const InputOptions& options) {
  const bool by_extension = options.format == InputFormat::kAuto;
  const slam::ScanList list = by_extension ? slam::ListScans(ExpandDataPath(options.folder))
                                           : slam::ListScans(ExpandDataPath(options.folder),
                                                             slam::FormatFromName(NameOf(options.format)));
  const std::optional<slam::InitialPoses> poses =
      options.poses.empty() ? slam::ReadInitialPoses(list)
                            : slam::ReadInitialPoses(list, ExpandDataPath(options.poses));
  notes_.push_back(poses ? "first guesses of the poses from " + poses->source
                         : "no poses beside the scans: all start at the identity (see input.poses)");
  for (std::size_t i = 0; i < list.scans.size(); ++i) {
    const slam::ScanFile& scan = list.scans[i];
    entries_.push_back({scan.name, i, poses ? poses->T_map_laser[i] : slam::Pose3{}, {}, scan.path});
  }
  format_ = list.format;
}

slam::PosedCloud ScanSource::Read(std::size_t i) const {
  const Entry& entry = entries_[i];
  slam::PointCloud cloud_laser =
      entry.file.empty() ? ScanOffice(office_, entry.number) : slam::ReadCloud(entry.file, format_).cloud;
  return {entry.name, std::move(cloud_laser), entry.T_odom_laser};
}

std::vector<std::filesystem::path> ScanSource::Files() const {
  std::vector<std::filesystem::path> files;
  for (const Entry& entry : entries_) {
    if (!entry.file.empty()) files.push_back(entry.file);
  }
  return files;
}

}  // namespace ariadne::experiments
