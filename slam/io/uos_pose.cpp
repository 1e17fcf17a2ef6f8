#include "slam/io/uos_pose.h"

#include <cmath>
#include <limits>
#include <string_view>

#include "slam/io/chunked_output.h"
#include "slam/io/pose_lines.h"
#include "slam/io/rotation_matrix.h"
#include "slam/io/uos_axes.h"
#include "slam/io/writable.h"

namespace ariadne::slam {
namespace {

Eigen::Vector3d ReadVector(StreamReader& reader, RowParser& parser, std::string_view what) {
  while (const std::optional<std::string_view> line = reader.NextLine()) {
    if (IsBlankLine(*line)) continue;
    return Eigen::Vector3d(ParseNumbers(reader, parser, *line, 3, what).data());
  }
  Fail("{}:{}: the file ends before the {}; add the line", reader.name(), reader.line() + 1, what);
}

UosFrame ParseFrame(const StreamReader& reader, std::span<const double> numbers) {
  const Eigen::Map<const Eigen::Matrix4d> T_uos(numbers.data());  // column by column, as Eigen stores it
  const auto rotation = RotationFromMatrix(FromUosRotation(T_uos.topLeftCorner<3, 3>()));
  if (!rotation || !T_uos.row(3).isApprox(Eigen::RowVector4d(0, 0, 0, 1), 1e-9)) {
    reader.FailAtLine("the matrix is not a rigid motion; write 16 numbers column by column, as 3DTK does");
  }
  const double type = numbers[16];
  if (type != std::round(type) || std::abs(type) > std::numeric_limits<int>::max()) {
    reader.FailAtLine("the last number is {}, expected a whole number (the type of the frame)", type);
  }
  return {{*rotation, FromUosPoint(T_uos.topRightCorner<3, 1>())}, static_cast<int>(type)};
}

void PrintFrame(ChunkedOutput& output, const UosFrame& frame) {
  CheckWritable(frame.T_map_laser);
  const Eigen::Matrix3d R_uos = ToUosRotation(RotationMatrixForFile(frame.T_map_laser.rotation));
  for (Eigen::Index column = 0; column < 3; ++column) {
    const Eigen::Vector3d axis = R_uos.col(column);
    output.Print("{} {} {} 0 ", axis.x(), axis.y(), axis.z());
  }
  const Eigen::Vector3d t_uos = ToUosPoint(frame.T_map_laser.translation).array() + 0.0;  // no -0
  output.Print("{:.12g} {:.12g} {:.12g} 1 {}\n", t_uos.x(), t_uos.y(), t_uos.z(), frame.type);
}

/// Ten decimals without the zeros at the end; the half turn is 180 and not -180.
std::string FormatDegrees(double degrees) {
  std::string text = fmt::format("{:.10f}", degrees);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text == "-0" || text == "-180" ? text.substr(1) : text;
}

}  // namespace

Pose3 ReadUosPose(std::istream& in, const std::string& name) {
  StreamReader reader(in, name);
  RowParser parser(reader);
  UosPose pose;
  pose.position_cm = ReadVector(reader, parser, "position x y z in cm");
  pose.euler_deg = ReadVector(reader, parser, "Euler angles about x y z in degrees");
  CheckOnlyBlankLinesFollow(reader, "remove the line, a .pose file has two");
  return FromUosPose(pose);
}

void WriteUosPose(std::ostream& out, const Pose3& T_map_laser) {
  CheckWritable(T_map_laser);
  const UosPose pose = ToUosPose(T_map_laser);
  const Eigen::Vector3d t_uos = pose.position_cm.array() + 0.0;  // no -0
  ChunkedOutput output(out);
  output.Print("{:.12g} {:.12g} {:.12g}\n", t_uos.x(), t_uos.y(), t_uos.z());
  output.Print("{} {} {}\n", FormatDegrees(pose.euler_deg.x()), FormatDegrees(pose.euler_deg.y()),
               FormatDegrees(pose.euler_deg.z()));
  output.Flush();
}

std::vector<UosFrame> ReadUosFrames(std::istream& in, const std::string& name) {
  StreamReader reader(in, name);
  RowParser parser(reader);
  std::vector<UosFrame> frames;
  while (const std::optional<std::string_view> line = NextPoseLine(reader)) {
    frames.push_back(ParseFrame(
        reader, ParseNumbers(reader, parser, *line, 17, "a 4x4 matrix column by column, and a type")));
  }
  if (frames.empty()) Fail("{}: holds no frames; expected a line of 17 numbers per iteration", name);
  return frames;
}

void WriteUosFrames(std::ostream& out, std::span<const UosFrame> frames) {
  if (frames.empty()) Fail("there are no frames to write; give the pose of the scan as one");
  ChunkedOutput output(out);
  for (const UosFrame& frame : frames) PrintFrame(output, frame);
  if (frames.size() == 1) PrintFrame(output, frames.front());
  output.Flush();
}

}  // namespace ariadne::slam
