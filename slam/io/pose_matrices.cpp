#include "slam/io/pose_matrices.h"

#include <optional>
#include <string_view>

#include "slam/base/error.h"
#include "slam/io/chunked_output.h"
#include "slam/io/pose_lines.h"
#include "slam/io/rotation_matrix.h"
#include "slam/io/writable.h"

namespace ariadne::slam {
namespace {

constexpr std::string_view kMatrixColumns = "[R | t] row by row";

Pose3 ParseMatrixLine(const StreamReader& reader, RowParser& parser, std::string_view line) {
  const std::span<const double> numbers = ParseNumbers(reader, parser, line, 12, kMatrixColumns);
  const Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>> matrix(numbers.data());
  const std::optional<Eigen::Quaterniond> rotation = RotationFromMatrix(matrix.leftCols<3>());
  if (!rotation) {
    reader.FailAtLine("the matrix is not a rotation within 1e-3; order the numbers {}", kMatrixColumns);
  }
  return {*rotation, matrix.col(3)};
}

NamedPose ParseListLine(const StreamReader& reader, RowParser& parser, std::string_view line, bool named) {
  if (!named) return {"", ParseMatrixLine(reader, parser, line)};
  const std::string_view name = SplitAtBlanks(line).front();
  const auto after = static_cast<std::size_t>(name.data() + name.size() - line.data());
  return {std::string(name), ParseMatrixLine(reader, parser, line.substr(after))};
}

void PrintMatrix(ChunkedOutput& output, const Pose3& pose) {
  CheckWritable(pose);
  const Eigen::Matrix3d R = RotationMatrixForFile(pose.rotation);
  for (Eigen::Index row = 0; row < 3; ++row) {
    output.Print("{} {} {} {}{}", R(row, 0), R(row, 1), R(row, 2), pose.translation[row],
                 row < 2 ? " " : "\n");
  }
}

}  // namespace

std::vector<NamedPose> ReadPoseList(StreamReader& reader) {
  RowParser parser(reader);
  std::optional<bool> named;  // told by the first pose, for all lines alike
  return CollectLines(reader, [&](std::string_view line) {
    if (!named) named = SplitAtBlanks(line).size() == 13;
    return ParseListLine(reader, parser, line, *named);
  });
}

std::vector<Pose3> ReadKittiPoses(std::istream& in, const std::string& name) {
  StreamReader reader(in, name);
  RowParser parser(reader);
  return CollectLines(reader, [&](std::string_view line) { return ParseMatrixLine(reader, parser, line); });
}

void WriteKittiPoses(std::ostream& out, std::span<const Pose3> poses) {
  ChunkedOutput output(out);
  for (const Pose3& pose : poses) PrintMatrix(output, pose);
  output.Flush();
}

std::vector<NamedPose> ReadPoseList(std::istream& in, const std::string& name) {
  StreamReader reader(in, name);
  return ReadPoseList(reader);
}

void WritePoseList(std::ostream& out, std::span<const NamedPose> poses) {
  ChunkedOutput output(out);
  for (const auto& [name, pose] : poses) {
    if (SplitAtBlanks(name).size() != 1 || name.starts_with('#')) {
      Fail("cannot write a pose named {}; a name must be one word", Quoted(name));
    }
    output.Print("{} ", name);
    PrintMatrix(output, pose);
  }
  output.Flush();
}

}  // namespace ariadne::slam
