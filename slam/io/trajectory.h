#pragma once

#include <istream>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "slam/geometry/pose3.h"

namespace ariadne::slam {

// Trajectories as text, a pose per line, in metres and the axes of this project; `#` begins a comment.
// A line that is short, long, empty, or not finite, or whose rotation is not one within 1e-3, is an Error
// with file and line. Numbers are written with all their digits.

struct StampedPose {
  double stamp = 0.0;  // [s]
  Pose3 pose;
};

/// A pose of a list, where the lines may begin with a word that says whose pose it is.
struct NamedPose {
  std::string name;  // empty where the file has none
  Pose3 pose;
};

/// TUM: "stamp tx ty tz qx qy qz qw".
std::vector<StampedPose> ReadTum(std::istream& in, const std::string& name);
void WriteTum(std::ostream& out, std::span<const StampedPose> poses);

/// KITTI odometry: 12 numbers, the 3x4 matrix [R | t] row by row.
std::vector<Pose3> ReadKittiPoses(std::istream& in, const std::string& name);
void WriteKittiPoses(std::ostream& out, std::span<const Pose3> poses);

/// The same matrices, each after the name of its scan (a word). Reading accepts lists without names too.
std::vector<NamedPose> ReadPoseList(std::istream& in, const std::string& name);
void WritePoseList(std::ostream& out, std::span<const NamedPose> poses);

/// Any of these, told from the first line by its number of columns (8; 12; 13); stamps are dropped.
std::vector<NamedPose> ReadAnyPoses(std::istream& in, const std::string& name);

}  // namespace ariadne::slam
