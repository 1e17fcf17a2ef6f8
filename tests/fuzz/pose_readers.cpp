#include <istream>
#include <ostream>
#include <span>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "slam/io/g2o.h"
#include "slam/io/trajectory.h"
#include "slam/io/uos_pose.h"
#include "tests/fuzz/accepts.h"
#include "tests/fuzz/read_by.h"

namespace ariadne::fuzz {
/// Near 90 deg about y, Euler angles change with the last bits of a rotation: here the poses must be equal.
bool AcceptsUosPose(std::string_view bytes) {
  slam::Pose3 pose;
  try {
    pose = ReadBytes(bytes, slam::ReadUosPose);
  } catch (const Error&) {
    return false;
  }
  const slam::Pose3 again = ReadBytes(Written(slam::WriteUosPose, pose), slam::ReadUosPose);
  const bool equal =
      pose.translation.isApprox(again.translation, 1e-11) && RotationDistance(pose, again) < 1e-9;
  if (!equal) throw std::logic_error("the pose that was written is not read");
  return true;
}

bool AcceptsUosFrames(std::string_view bytes) {
  return Accepts(bytes, slam::ReadUosFrames, slam::WriteUosFrames);
}

bool AcceptsTum(std::string_view bytes) { return Accepts(bytes, slam::ReadTum, slam::WriteTum); }

bool AcceptsPoseMatrices(std::string_view bytes) {
  return Accepts(bytes, slam::ReadKittiPoses, slam::WriteKittiPoses);
}

bool AcceptsPoseList(std::string_view bytes) {
  const auto read = [](std::istream& in, const std::string& name) { return slam::ReadPoseList(in, name); };
  return Accepts(bytes, read, slam::WritePoseList);
}

bool AcceptsAnyPoses(std::string_view bytes) {
  const auto write = [](std::ostream& out, const std::vector<slam::NamedPose>& poses) {
    for (const slam::NamedPose& named : poses) slam::WriteKittiPoses(out, std::span(&named.pose, 1));
  };
  return Accepts(bytes, slam::ReadAnyPoses, write);
}

bool AcceptsG2o(std::string_view bytes) {
  const auto write = [](std::ostream& out, const slam::G2oFile& file) {
    std::visit([&](const auto& graph) { slam::WriteG2o(out, graph); }, file.graph);
  };
  return Accepts(bytes, slam::ReadG2o, write);
}

}  // namespace ariadne::fuzz
