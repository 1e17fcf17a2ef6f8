#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "experiments/run/office_scans.h"
#include "experiments/run/simulated_tour.h"
#include "slam/base/options.h"
#include "slam/io/cloud_format.h"
#include "slam/scan/point_cloud.h"

namespace ariadne::experiments {

enum class InputFormat { kAuto, kUos, kXyz, kPly, kPcd, kKitti };

struct InputOptions {
  std::string folder = "builtin:office";
  InputFormat format = InputFormat::kAuto;
  std::string poses;
  int first = 0;
  int last = -1;
  OfficeScanOptions office;
  TourOptions tour;

  /// Those of an experiment that needs a simulated tour.
  static InputOptions OfTour() {
    InputOptions options;
    options.folder = "builtin:tour";
    return options;
  }

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("folder", self.folder,
          "of the scans; $ARIADNE_DATA in it stands for the environment's; builtin:office and builtin:tour "
          "need "
          "no files");
    visit("format", self.format, "of the files; auto: by their extensions");
    visit("poses", self.poses,
          "file of first guesses; empty: .pose or .frames files, or a trajectory beside them");
    visit("first", self.first, Unit(""), Range{0, 1e9}, "number of the first scan, in natural order");
    visit("last", self.last, Unit(""), Range{-1, 1e9}, "number of the last scan; -1: to the end");
    visit("office", self.office, "the scans of builtin:office");
    visit("tour", self.tour, "the simulated robot of builtin:tour");
  }
};

/// Scans that are read one at a time.
class ScanSource {
 public:
  explicit ScanSource(const InputOptions& options);

  std::size_t size() const { return entries_.size(); }
  const std::string& name(std::size_t i) const { return entries_[i].name; }
  const slam::Pose3& T_odom_laser(std::size_t i) const { return entries_[i].T_odom_laser; }
  /// Where the laser really was; only known of simulated scans.
  const std::optional<slam::Pose3>& truth(std::size_t i) const { return entries_[i].T_map_laser_true; }

  /// Reads a scan, at its pose by odometry. Error with file and line.
  slam::PosedCloud Read(std::size_t i) const;

  /// The files that hold scans; none for built-in ones.
  std::vector<std::filesystem::path> Files() const;
  /// Sentences that a user should see: where the poses come from.
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  struct Entry {
    std::string name;
    std::size_t number = 0;  // in natural order, over all that there are
    slam::Pose3 T_odom_laser;
    std::optional<slam::Pose3> T_map_laser_true;
    std::filesystem::path file;  // empty: a built-in scan
  };
  void OpenOffice(const OfficeScanOptions& options);
  void OpenTour(const TourOptions& options);
  void OpenFolder(const InputOptions& options);
  void ReadTruth(const std::filesystem::path& file);
  slam::PointCloud ReadCloudOf(const Entry& entry) const;
  void Select(const InputOptions& options);

  std::vector<Entry> entries_;
  OfficeScanOptions office_;
  std::shared_ptr<const SimulatedTour> tour_;  // of builtin:tour
  slam::CloudFormat format_ = slam::CloudFormat::kUos;
  std::vector<std::string> notes_;
};

}  // namespace ariadne::experiments

namespace ariadne {

template <>
struct EnumNames<experiments::InputFormat> {
  static constexpr std::array<std::string_view, 6> value{"auto", "uos", "xyz", "ply", "pcd", "kitti"};
};

}  // namespace ariadne
