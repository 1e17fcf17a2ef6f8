#pragma once

#include <istream>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "slam/geometry/pose3.h"

namespace ariadne::slam {

/// Reads a uos `.pose` file: the position [cm] on the first line, the Euler angles [deg] on the second, in
/// left-handed axes (uos_axes.h).
Pose3 ReadUosPose(std::istream& in, const std::string& name);
void WriteUosPose(std::ostream& out, const Pose3& T_map_laser);

/// A line of a uos `.frames` file: the pose of a scan after an iteration, and how a viewer should colour
/// it.
struct UosFrame {
  /// What the number after the matrix can say; others are kept as they are.
  static constexpr int kInvalid = 0;
  static constexpr int kIcp = 1;
  static constexpr int kIcpInactive = 2;

  Pose3 T_map_laser;
  int type = kIcp;
};

/// Reads `.frames`: on each line 16 numbers, the 4x4 matrix column by column in centimetres and left-handed
/// axes, and the type. There is at least one; the last is the final pose.
std::vector<UosFrame> ReadUosFrames(std::istream& in, const std::string& name);

/// Writes at least two lines, because the viewer of 3DTK expects them: a single frame is written twice.
void WriteUosFrames(std::ostream& out, std::span<const UosFrame> frames);

}  // namespace ariadne::slam
