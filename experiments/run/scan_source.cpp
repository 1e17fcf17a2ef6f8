#include "experiments/run/scan_source.h"

#include "experiments/run/data_path.h"
#include "slam/base/error.h"
#include "slam/io/cloud_io.h"
#include "slam/io/file.h"
#include "slam/io/initial_poses.h"
#include "slam/io/scan_list.h"
#include "slam/io/trajectory.h"

namespace ariadne::experiments {
namespace {

constexpr std::string_view kOffice = "builtin:office";
constexpr std::string_view kTour = "builtin:tour";
constexpr std::string_view kTruth =
    "truth.tum";  // beside simulated scans, as the experiment `simulate` leaves it

std::vector<slam::StampedPose> ReadTrajectory(const std::filesystem::path& file) {
  std::ifstream in = slam::OpenForReading(file);
  return slam::ReadTum(in, file.string());
}

}  // namespace

ScanSource::ScanSource(const InputOptions& options) {
  CheckOptions(options, "input.");
  if (options.folder == kOffice) {
    OpenOffice(options.office);
  } else if (options.folder == kTour) {
    OpenTour(options.tour);
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

void ScanSource::OpenTour(const TourOptions& options) {
  tour_ = std::make_shared<const SimulatedTour>(options);
  for (std::size_t i = 0; i < tour_->size(); ++i) {
    entries_.push_back(
        {fmt::format("scan{:03}", i), i, tour_->T_odom_laser(i), tour_->T_map_laser_true(i), {}});
  }
  notes_.push_back(fmt::format("simulated tour through {}, seed {}: the true poses are known",
                               tour_->scene().world().name, options.seed));
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
  ReadTruth(list.folder / kTruth);
}

void ScanSource::ReadTruth(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return;
  const std::vector<slam::StampedPose> truth = ReadTrajectory(file);
  if (truth.size() != entries_.size()) {
    Fail("{}: {} poses, but there are {} scans", file.string(), truth.size(), entries_.size());
  }
  for (std::size_t i = 0; i < truth.size(); ++i) entries_[i].T_map_laser_true = truth[i].pose;
  notes_.push_back("true poses from " + file.string());
}

slam::PosedCloud ScanSource::Read(std::size_t i) const {
  const Entry& entry = entries_[i];
  return {entry.name, ReadCloudOf(entry), entry.T_odom_laser};
}

slam::PointCloud ScanSource::ReadCloudOf(const Entry& entry) const {
  if (!entry.file.empty()) return slam::ReadCloud(entry.file, format_).cloud;
  if (tour_) return slam::ToPointCloud(tour_->TakeScan(entry.number, Parallel(1)));
  return ScanOffice(office_, entry.number);
}

std::vector<std::filesystem::path> ScanSource::Files() const {
  std::vector<std::filesystem::path> files;
  for (const Entry& entry : entries_) {
    if (!entry.file.empty()) files.push_back(entry.file);
  }
  return files;
}

}  // namespace ariadne::experiments
