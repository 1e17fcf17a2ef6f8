#include "experiments/studies/run_scans.h"

#include <fstream>

#include "experiments/config/options_io.h"
#include "slam/base/error.h"
#include "slam/io/file.h"
#include "slam/io/trajectory.h"

namespace ariadne::experiments {
namespace {

/// A mission keeps its scans in the run.
RegisterOptions OptionsOfExploration(const std::filesystem::path& run) {
  RegisterOptions options;
  options.input.folder = (run / "scans").string();
  return options;
}

RegisterOptions ReadRunOptions(const std::filesystem::path& run) {
  const std::filesystem::path config = run / "config.yaml";
  OptionEntries entries = OptionEntries::FromFile(config.string());
  const std::optional<OptionEntry> experiment = entries.Take("experiment");
  if (experiment && experiment->value == "explore") return OptionsOfExploration(run);
  if (!experiment || experiment->value != "register")
    Fail("{}: only runs of the experiments register and explore have a map", config.string());
  return ReadOptions<RegisterOptions>(entries);
}

}  // namespace

RunScans::RunScans(const std::filesystem::path& run)
    : options_(ReadRunOptions(run)), source_(options_.input) {
  const std::filesystem::path pose_file = run / "poses.txt";
  std::ifstream in = slam::OpenForReading(pose_file);
  const std::vector<slam::NamedPose> poses = slam::ReadPoseList(in, pose_file.string());
  if (poses.size() != source_.size())
    Fail("{}: {} poses, but {} scans", pose_file.string(), poses.size(), source_.size());
  for (const slam::NamedPose& named : poses) T_map_laser_.push_back(named.pose);
}

slam::PosedCloud RunScans::Read(std::size_t i) const {
  const auto [min_range, max_range] = options_.mapper.scan;
  return {source_.name(i), slam::WithinRange(source_.Read(i).cloud_laser, min_range, max_range),
          T_map_laser_[i]};
}

RegisteredMap ReadRegisteredMap(const std::filesystem::path& run) {
  const RunScans scans(run);
  RegisteredMap map{{}, scans.options().input, scans.source().truth(0)};
  for (std::size_t i = 0; i < scans.size(); ++i) map.scans.push_back(scans.Read(i));
  return map;
}

}  // namespace ariadne::experiments
