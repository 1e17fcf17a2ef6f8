#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "slam/geometry/pose3.h"
#include "slam/io/scan_list.h"

namespace ariadne::slam {

/// First guesses of the poses of scans, usually from odometry.
struct InitialPoses {
  std::vector<Pose3> T_map_laser;  // one per scan
  std::string source;              // where they come from, for people: "garage13/initial_poses.txt"
};

/// Reads the poses of all scans of a list from the first of these that exists: the file `explicit_path`
/// (TUM, KITTI or a list of 3x4 matrices, told from its columns; an Error if it does not exist); a `.pose`
/// file beside each scan; a `.frames` file beside each scan, of which the last line counts; or one of the
/// files initial_poses.txt, poses.txt and trajectory.tum in the folder of the scans or the one above.
///
/// A pose belongs to the scan with its name or number where the file has such, else to the scan in its
/// place. A scan without pose, and more poses than scans where they have no names, are Errors that say so.
/// Nothing is returned where there are no poses at all, so that the caller can say that it starts from
/// identity.
std::optional<InitialPoses> ReadInitialPoses(
    const ScanList& list, const std::optional<std::filesystem::path>& explicit_path = std::nullopt);

}  // namespace ariadne::slam
