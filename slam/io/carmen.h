#pragma once

#include <istream>
#include <memory>
#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "slam/io/stream_reader.h"
#include "slam/scan/scan.h"

namespace ariadne::slam {

/// What a robot with a level 2D scanner logged of one sweep.
struct CarmenSweep {
  ScannerModel scanner;
  LaserSweep sweep;    // ranges as float [m]
  Pose2 T_odom_laser;  // by the wheels alone, as T_odom_base
  Pose2 T_odom_base;
  std::size_t line = 0;  // in the file, from 1
};

/// Reads a log of CARMEN (`.log`, `.clf`; also as it is compressed by bzip2) sweep by sweep, so that a log
/// of any length takes the memory of one. Of its records, FLASER counts (the front laser):
///
///   FLASER n r_1 .. r_n  x y theta  odom_x odom_y odom_theta  ipc_timestamp ipc_hostname logger_timestamp
///
/// with the pose of the laser, that of the robot, in m and rad, and ipc_timestamp as the stamp. The n beams
/// span 180 deg from right to left, as those of the SICK LMS: in steps of 180 / n degrees, or 180 / (n - 1)
/// if n is odd and the last beam looks to the left. From kNoReturn on, a range says that nothing came back.
/// Other records are left out. Error with file and line for an FLASER record that is short or long, or has
/// a number that is not finite or a range below zero; and for a log without any.
class CarmenReader {
 public:
  /// The SICK LMS says 81.83 m and more for echoes too weak, too strong or none [m].
  static constexpr double kNoReturn = 80.0;

  /// `in` must live as long as the reader.
  CarmenReader(std::istream& in, const std::string& name);

  /// The next sweep; nothing at the end.
  std::optional<CarmenSweep> Next();

 private:
  CarmenSweep Parse(std::string_view line) const;

  std::unique_ptr<std::istream> decompressed_;  // empty where the log is text
  StreamReader reader_;
  bool found_ = false;
};

/// All sweeps at once.
std::vector<CarmenSweep> ReadCarmen(std::istream& in, const std::string& name);

/// Writes FLASER records with all digits. Error where a scanner does not span 180 deg as above, or a number
/// is not finite (other than LaserSweep::kNoReturn).
void WriteCarmen(std::ostream& out, std::span<const CarmenSweep> sweeps);

}  // namespace ariadne::slam
