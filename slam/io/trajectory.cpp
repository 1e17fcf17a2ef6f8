#include "slam/io/trajectory.h"

#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

#include "slam/base/error.h"
#include "slam/io/chunked_output.h"
#include "slam/io/pose_lines.h"
#include "slam/io/pose_matrices.h"
#include "slam/io/writable.h"

namespace ariadne::slam {
namespace {

constexpr std::string_view kTumColumns = "stamp tx ty tz qx qy qz qw";
constexpr double kQuaternionTolerance = 1e-3;

/// A quaternion that is unit to the last digits stays as it is, so that what was written is read again.
Eigen::Quaterniond Normalized(const StreamReader& reader, const Eigen::Quaterniond& q) {
  const double norm = q.norm();
  if (!(std::abs(norm - 1.0) <= kQuaternionTolerance)) {
    reader.FailAtLine("the quaternion has length {:.6g} instead of 1; order them qx qy qz qw", norm);
  }
  return std::abs(norm - 1.0) < 4.0 * std::numeric_limits<double>::epsilon() ? q : q.normalized();
}

StampedPose ParseTumLine(const StreamReader& reader, RowParser& parser, std::string_view line) {
  const std::span<const double> n = ParseNumbers(reader, parser, line, 8, kTumColumns);
  return {n[0], {Normalized(reader, Eigen::Quaterniond(n[7], n[4], n[5], n[6])), {n[1], n[2], n[3]}}};
}

std::vector<StampedPose> ReadTumLines(StreamReader& reader) {
  RowParser parser(reader);
  return CollectLines(reader, [&](std::string_view line) { return ParseTumLine(reader, parser, line); });
}

/// Of the first pose; the lines before it are read.
std::size_t ColumnsOfFirstPose(StreamReader& reader) {
  while (const std::optional<std::string_view> line = reader.PeekLine()) {
    if (!line->starts_with('#')) return SplitAtBlanks(*line).size();
    reader.NextLine();
  }
  return 0;
}

}  // namespace

std::vector<StampedPose> ReadTum(std::istream& in, const std::string& name) {
  StreamReader reader(in, name);
  return ReadTumLines(reader);
}

void WriteTum(std::ostream& out, std::span<const StampedPose> poses) {
  ChunkedOutput output(out);
  for (const auto& [stamp, pose] : poses) {
    CheckWritable(pose);
    if (!std::isfinite(stamp)) Fail("cannot write a pose whose stamp is NaN or infinite");
    const Eigen::Vector3d& t = pose.translation;
    const Eigen::Quaterniond& q = pose.rotation;
    output.Print("{} {} {} {} {} {} {} {}\n", stamp, t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w());
  }
  output.Flush();
}

std::vector<NamedPose> ReadAnyPoses(std::istream& in, const std::string& name) {
  StreamReader reader(in, name);
  const std::size_t columns = ColumnsOfFirstPose(reader);
  if (columns == 12 || columns == 13 || columns == 0) return ReadPoseList(reader);
  if (columns != 8) {
    Fail("{}:{}: found {} columns, expected 8 ({}), 12 (a 3x4 matrix) or 13 (a name and a 3x4 matrix)",
         name, reader.line() + 1, columns, kTumColumns);
  }
  std::vector<NamedPose> poses;
  for (const StampedPose& stamped : ReadTumLines(reader)) poses.push_back({"", stamped.pose});
  return poses;
}

}  // namespace ariadne::slam
