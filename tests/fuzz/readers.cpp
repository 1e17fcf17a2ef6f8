#include "tests/fuzz/readers.h"

#include <algorithm>
#include <array>

#include "tests/fuzz/read_by.h"

namespace ariadne::fuzz {
namespace {

constexpr std::array<Reader, 24> kReaders{{{"uos_cloud", AcceptsUosCloud},
                                           {"uos_pose", AcceptsUosPose},
                                           {"uos_frames", AcceptsUosFrames},
                                           {"xyz", AcceptsXyz},
                                           {"ply", AcceptsPly},
                                           {"pcd", AcceptsPcd},
                                           {"kitti", AcceptsKitti},
                                           {"tum", AcceptsTum},
                                           {"kitti_poses", AcceptsPoseMatrices},
                                           {"pose_list", AcceptsPoseList},
                                           {"any_poses", AcceptsAnyPoses},
                                           {"g2o", AcceptsG2o},
                                           {"carmen", AcceptsCarmen},
                                           {"robot_log", AcceptsRobotLog},
                                           {"robot_call", AcceptsRobotCall},
                                           {"lms200_stream", AcceptsLms200Stream},
                                           {"lms200_requests", AcceptsLms200Requests},
                                           {"lms200_payload", AcceptsLms200Payload},
                                           {"dynamixel", AcceptsDynamixel},
                                           {"roboclaw", AcceptsRoboclaw},
                                           {"roboclaw_reply", AcceptsRoboclawReply},
                                           {"hobby_servo", AcceptsHobbyServo},
                                           {"telegrams", AcceptsTelegrams},
                                           {"line_log", AcceptsLineLog}}};

}  // namespace

std::span<const Reader> Readers() { return kReaders; }

int Feed(std::string_view reader, const std::uint8_t* data, std::size_t size) {
  const auto found = std::find_if(kReaders.begin(), kReaders.end(),
                                  [&](const Reader& known) { return known.name == reader; });
  found->accepts({reinterpret_cast<const char*>(data), size});
  return 0;
}

}  // namespace ariadne::fuzz
