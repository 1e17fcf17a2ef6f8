#include "slam/io/initial_poses.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <system_error>

#include "slam/base/error.h"
#include "slam/io/file.h"
#include "slam/io/trajectory.h"
#include "slam/io/uos_pose.h"

namespace ariadne::slam {
namespace {

namespace fs = std::filesystem;

bool IsFile(const fs::path& path) {
  std::error_code ignored;  // what cannot be asked for is not there
  return fs::is_regular_file(path, ignored);
}

/// "scan003" is meant by "scan003", "003" and "3".
bool Means(std::string_view pose_name, std::string_view scan_name) {
  if (pose_name == scan_name) return true;
  const std::size_t number = scan_name.find_last_not_of("0123456789") + 1;
  const auto is_number = [](std::string_view text) {
    return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
  };
  const auto value = [](std::string_view digits) {
    return digits.substr(std::min(digits.find_first_not_of('0'), digits.size()));
  };
  const std::string_view scan_number = scan_name.substr(number);
  return is_number(pose_name) && is_number(scan_number) && value(pose_name) == value(scan_number);
}

std::vector<Pose3> MatchByName(const std::string& file, const std::vector<NamedPose>& poses,
                               const std::vector<ScanFile>& scans) {
  std::vector<Pose3> matched;
  for (const ScanFile& scan : scans) {
    const auto means = [&](const NamedPose& pose) { return Means(pose.name, scan.name); };
    const auto found = std::find_if(poses.begin(), poses.end(), means);
    if (found == poses.end()) Fail("{}: has no pose for {}; add a line for it", file, scan.name);
    const auto again = std::find_if(found + 1, poses.end(), means);
    if (again != poses.end()) Fail("{}: has more than one pose for {}; remove one", file, scan.name);
    matched.push_back(found->pose);
  }
  return matched;
}

std::vector<Pose3> MatchByPlace(const std::string& file, const std::vector<NamedPose>& poses,
                                const std::vector<ScanFile>& scans) {
  if (poses.size() < scans.size()) {
    Fail("{}: holds {} poses for {} scans; {} has none", file, poses.size(), scans.size(),
         scans[poses.size()].name);
  }
  if (poses.size() > scans.size()) {
    Fail("{}: holds {} poses for {} scans, the last of which is {}; remove the others, or name the poses",
         file, poses.size(), scans.size(), scans.back().name);
  }
  std::vector<Pose3> matched;
  matched.reserve(poses.size());
  for (const NamedPose& pose : poses) matched.push_back(pose.pose);
  return matched;
}

InitialPoses ReadPoseFile(const fs::path& path, const std::vector<ScanFile>& scans) {
  const std::vector<NamedPose> poses = ReadFile(path, ReadAnyPoses);
  // Names that mean no scan at all are something else, such as time stamps.
  const bool named = std::any_of(poses.begin(), poses.end(), [&](const NamedPose& pose) {
    return std::any_of(scans.begin(), scans.end(),
                       [&](const ScanFile& scan) { return Means(pose.name, scan.name); });
  });
  const std::string file = path.string();
  return {named ? MatchByName(file, poses, scans) : MatchByPlace(file, poses, scans), file};
}

fs::path Beside(const ScanFile& scan, std::string_view extension) {
  return fs::path(scan.path).replace_extension(extension);
}

/// Reads a file with the extension beside each scan, if there are any.
template <typename Read>
std::optional<InitialPoses> ReadBesideScans(const ScanList& list, std::string_view extension,
                                            const Read& read) {
  const auto has_file = [&](const ScanFile& scan) { return IsFile(Beside(scan, extension)); };
  if (std::none_of(list.scans.begin(), list.scans.end(), has_file)) return std::nullopt;
  InitialPoses poses{{}, fmt::format("{} files in {}", extension, list.folder.string())};
  for (const ScanFile& scan : list.scans) {
    if (!has_file(scan)) {
      Fail("{}: is missing, while other scans have one", Beside(scan, extension).string());
    }
    poses.T_map_laser.push_back(ReadFile(Beside(scan, extension), read));
  }
  return poses;
}

std::optional<fs::path> FindPoseFile(const fs::path& folder) {
  constexpr std::array<std::string_view, 3> kFileNames{"initial_poses.txt", "poses.txt", "trajectory.tum"};
  // The slash at the end makes "scans" and "scans/" the same to parent_path.
  const fs::path absolute = (fs::absolute(folder).lexically_normal() / "").parent_path();
  for (const fs::path& place : {absolute, absolute.parent_path()}) {
    for (const std::string_view name : kFileNames) {
      if (IsFile(place / name)) return place / name;
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<InitialPoses> ReadInitialPoses(const ScanList& list,
                                             const std::optional<fs::path>& explicit_path) {
  if (explicit_path) return ReadPoseFile(*explicit_path, list.scans);
  if (auto poses = ReadBesideScans(list, ".pose", ReadUosPose)) return poses;
  const auto read_last_frame = [](std::istream& in, const std::string& name) {
    return ReadUosFrames(in, name).back().T_map_laser;
  };
  if (auto poses = ReadBesideScans(list, ".frames", read_last_frame)) return poses;
  if (const auto path = FindPoseFile(list.folder)) return ReadPoseFile(*path, list.scans);
  return std::nullopt;
}

}  // namespace ariadne::slam
