#include "tests/fuzz/readers.h"

#include <algorithm>
#include <array>
#include <boost/crc.hpp>
#include <cstring>
#include <iterator>
#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "drivers/hardware/dynamixel/packet.h"
#include "drivers/hardware/hobby_servo/maestro.h"
#include "drivers/hardware/line_log_stream.h"
#include "drivers/hardware/lms200/command.h"
#include "drivers/hardware/lms200/reply.h"
#include "drivers/hardware/lms200/telegram_decoder.h"
#include "drivers/hardware/roboclaw/packet.h"
#include "drivers/replay/log_frame.h"
#include "drivers/replay/robot_log.h"
#include "slam/base/error.h"
#include "slam/io/carmen.h"
#include "slam/io/g2o.h"
#include "slam/io/kitti.h"
#include "slam/io/pcd.h"
#include "slam/io/ply.h"
#include "slam/io/trajectory.h"
#include "slam/io/uos_cloud.h"
#include "slam/io/uos_pose.h"
#include "slam/io/xyz.h"
#include "slam/scan/slices.h"

namespace ariadne::fuzz {
namespace {

template <typename Read>
auto ReadBytes(std::string_view bytes, const Read& read) {
  std::istringstream in{std::string(bytes)};
  return read(in, "input");
}

template <typename Write, typename Value>
std::string Written(const Write& write, const Value& value) {
  std::ostringstream out;
  write(out, value);
  return out.str();
}

/// Whether `read` accepts the bytes, and `write` can say what was read; then it must say it twice alike.
template <typename Read, typename Write>
bool Accepts(std::string_view bytes, const Read& read, const Write& write) {
  std::string first;
  try {
    first = Written(write, ReadBytes(bytes, read));
  } catch (const Error&) {
    return false;
  }
  if (Written(write, ReadBytes(first, read)) != first) {
    throw std::logic_error("written differently the second time");
  }
  return true;
}

slam::PointCloud ReadPcdCloud(std::istream& in, const std::string& name) {
  return slam::ReadPcd(in, name).cloud;
}

template <slam::PlyEncoding kEncoding>
void WritePlyAs(std::ostream& out, const slam::PointCloud& cloud) {
  slam::WritePly(out, cloud, kEncoding);
}

template <slam::PcdEncoding kEncoding>
void WritePcdAs(std::ostream& out, const slam::PointCloud& cloud) {
  slam::WritePcd(out, cloud, kEncoding);
}

bool AcceptsUosCloud(std::string_view bytes) {
  // What ReadCloud does with clouds that have no slices must survive any points as well.
  const auto read = [](std::istream& in, const std::string& name) {
    slam::PointCloud cloud = slam::ReadUosCloud(in, name);
    slam::InferSlices(cloud.positions);
    return cloud;
  };
  return Accepts(bytes, read, slam::WriteUosCloud);
}
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
bool AcceptsXyz(std::string_view bytes) { return Accepts(bytes, slam::ReadXyz, slam::WriteXyz); }
bool AcceptsPly(std::string_view bytes) {
  return Accepts(bytes, slam::ReadPly, WritePlyAs<slam::PlyEncoding::kAscii>) &&
         Accepts(bytes, slam::ReadPly, WritePlyAs<slam::PlyEncoding::kBinary>);
}
bool AcceptsPcd(std::string_view bytes) {
  return Accepts(bytes, ReadPcdCloud, WritePcdAs<slam::PcdEncoding::kAscii>) &&
         Accepts(bytes, ReadPcdCloud, WritePcdAs<slam::PcdEncoding::kBinary>) &&
         Accepts(bytes, ReadPcdCloud, WritePcdAs<slam::PcdEncoding::kBinaryCompressed>);
}
bool AcceptsKitti(std::string_view bytes) { return Accepts(bytes, slam::ReadKitti, slam::WriteKitti); }
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

bool AcceptsCarmen(std::string_view bytes) { return Accepts(bytes, slam::ReadCarmen, slam::WriteCarmen); }

std::string ReadRobotLogBytes(std::istream& in, const std::string& name) {
  drivers::RobotLog log(
      std::make_unique<std::istringstream>(std::string(std::istreambuf_iterator<char>(in), {})), name);
  std::string again = drivers::HeadOfLog();
  for (std::size_t i = 0; i < log.size(); ++i) again += drivers::FramedCall(log.Read(i));
  return again;
}
bool AcceptsRobotLog(std::string_view bytes) {
  return Accepts(bytes, ReadRobotLogBytes, [](std::ostream& out, const std::string& log) { out << log; });
}

/// The payload of a record, which no checksum guards here.
bool AcceptsRobotCall(std::string_view bytes) {
  const auto read = [](std::istream& in, const std::string&) {
    return drivers::DecodeCall(std::string(std::istreambuf_iterator<char>(in), {}));
  };
  return Accepts(bytes, read, [](std::ostream& out, const drivers::RobotCall& call) {
    out << drivers::EncodeCall(call);
  });
}

drivers::ByteView ViewOf(std::string_view bytes) {
  return {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
}

/// What a scanner sent, cut into pieces of at most `piece` bytes: its frames, without what lies between
/// them.
std::string FramesIn(std::string_view bytes, std::size_t piece) {
  drivers::lms200::TelegramDecoder decoder(drivers::lms200::Sender::kDevice);
  std::string frames;
  for (; !bytes.empty(); bytes.remove_prefix(std::min(piece, bytes.size()))) {
    decoder.Push(ViewOf(bytes.substr(0, piece)));
    while (const std::optional<drivers::lms200::Received> received = decoder.Next()) {
      if (received->kind != drivers::lms200::Received::Kind::kTelegram) continue;
      const drivers::Bytes frame = drivers::lms200::EncodeTelegram(received->telegram);
      frames.append(frame.begin(), frame.end());
    }
  }
  return frames;
}
bool AcceptsLms200Stream(std::string_view bytes) {
  const auto read = [](std::istream& in, const std::string&) {
    const std::string all(std::istreambuf_iterator<char>(in), {});
    std::string frames = FramesIn(all, all.size() + 1);
    for (const std::size_t piece : {1U, 5U, 100U}) {
      if (FramesIn(all, piece) != frames) throw std::logic_error("pieces are read differently");
    }
    if (frames.empty()) Fail("no telegram");
    return frames;
  };
  return Accepts(bytes, read, [](std::ostream& out, const std::string& frames) { out << frames; });
}

/// What a telegram of either side carries, which no checksum guards here.
bool AcceptsLms200Payload(std::string_view bytes) {
  using drivers::Bytes;
  const auto read = [](std::istream& in, const std::string&) {
    const std::string all(std::istreambuf_iterator<char>(in), {});
    if (!all.empty() && (static_cast<std::uint8_t>(all[0]) & drivers::lms200::kFromDevice) == 0) {
      return drivers::lms200::EncodeCommand(drivers::lms200::DecodeCommand(ViewOf(all)));
    }
    return drivers::lms200::EncodeReply(drivers::lms200::DecodeReply(ViewOf(all)));
  };
  return Accepts(bytes, read, [](std::ostream& out, const Bytes& payload) {
    out << std::string(payload.begin(), payload.end());
  });
}

/// The packets on a servo's bus, without what lies between them.
std::string PacketsIn(std::string_view bytes, std::size_t piece) {
  drivers::dynamixel::PacketDecoder decoder;
  std::string packets;
  for (; !bytes.empty(); bytes.remove_prefix(std::min(piece, bytes.size()))) {
    decoder.Push(ViewOf(bytes.substr(0, piece)));
    while (const std::optional<drivers::dynamixel::Packet> packet = decoder.Next()) {
      const drivers::Bytes encoded = drivers::dynamixel::EncodePacket(*packet);
      packets.append(encoded.begin(), encoded.end());
    }
  }
  return packets;
}
bool AcceptsDynamixel(std::string_view bytes) {
  const auto read = [](std::istream& in, const std::string&) {
    const std::string all(std::istreambuf_iterator<char>(in), {});
    std::string packets = PacketsIn(all, all.size() + 1);
    if (PacketsIn(all, 1) != packets) throw std::logic_error("pieces are read differently");
    if (packets.empty()) Fail("no packet");
    return packets;
  };
  return Accepts(bytes, read, [](std::ostream& out, const std::string& packets) { out << packets; });
}

/// Requests to a motor board at address 0x80, and what else may stand between them.
std::string RequestsIn(std::string_view bytes, std::size_t piece) {
  drivers::roboclaw::RequestDecoder decoder(0x80);
  std::string requests;
  for (; !bytes.empty(); bytes.remove_prefix(std::min(piece, bytes.size()))) {
    decoder.Push(ViewOf(bytes.substr(0, piece)));
    while (const std::optional<drivers::roboclaw::Request> request = decoder.Next()) {
      const drivers::Bytes encoded = drivers::roboclaw::EncodeRequest(0x80, request->code, request->data);
      requests.append(encoded.begin(), encoded.end());
    }
  }
  return requests;
}
bool AcceptsRoboclaw(std::string_view bytes) {
  const auto read = [](std::istream& in, const std::string&) {
    const std::string all(std::istreambuf_iterator<char>(in), {});
    std::string requests = RequestsIn(all, all.size() + 1);
    if (RequestsIn(all, 1) != requests) throw std::logic_error("pieces are read differently");
    for (const auto code : {drivers::roboclaw::Code::kEncoders, drivers::roboclaw::Code::kVersion}) {
      try {
        drivers::roboclaw::DecodeReply(0x80, code, ViewOf(all));
      } catch (const Error&) {  // the proper answer to damage
      }
    }
    if (requests.empty()) Fail("no request");
    return requests;
  };
  return Accepts(bytes, read, [](std::ostream& out, const std::string& requests) { out << requests; });
}

/// Requests to a servo controller.
std::string ServoRequestsIn(std::string_view bytes, std::size_t piece) {
  drivers::hobby_servo::RequestDecoder decoder;
  std::string requests;
  for (; !bytes.empty(); bytes.remove_prefix(std::min(piece, bytes.size()))) {
    decoder.Push(ViewOf(bytes.substr(0, piece)));
    while (const std::optional<drivers::hobby_servo::Request> request = decoder.Next()) {
      const drivers::Bytes encoded = drivers::hobby_servo::EncodeRequest(*request);
      requests.append(encoded.begin(), encoded.end());
    }
  }
  return requests;
}
bool AcceptsHobbyServo(std::string_view bytes) {
  const auto read = [](std::istream& in, const std::string&) {
    const std::string all(std::istreambuf_iterator<char>(in), {});
    std::string requests = ServoRequestsIn(all, all.size() + 1);
    if (ServoRequestsIn(all, 1) != requests) throw std::logic_error("pieces are read differently");
    if (requests.empty()) Fail("no request");
    return requests;
  };
  return Accepts(bytes, read, [](std::ostream& out, const std::string& requests) { out << requests; });
}

/// The same file with the checksums that its chunks should have, so that what lies behind them is reached.
drivers::Bytes WithChecksums(const std::string& file) {
  drivers::Bytes mended(file.begin(), file.end());
  for (std::size_t at = 8; at + 8 <= mended.size();) {
    std::uint32_t length = 0;
    std::memcpy(&length, mended.data() + at, sizeof length);
    if (length > mended.size() - at - 8) break;
    boost::crc_32_type crc;
    crc.process_bytes(&length, sizeof length);
    crc.process_bytes(mended.data() + at + 8, length);
    const std::uint32_t checksum = crc.checksum();
    std::memcpy(mended.data() + at + 4, &checksum, sizeof checksum);
    at += 8 + std::size_t{length};
  }
  return mended;
}

/// A file of a log of lines: its records, if it ends with a whole one.
std::vector<drivers::LoggedRecord> RecordsIn(drivers::ByteView file) {
  drivers::LineLogDecoder decoder(file);
  std::vector<drivers::LoggedRecord> records;
  while (std::optional<drivers::LoggedRecord> record = decoder.Next()) records.push_back(*record);
  if (decoder.position() != file.size()) Fail("torn");
  return records;
}
bool AcceptsLineLog(std::string_view bytes) {
  const auto read = [](std::istream& in, const std::string&) {
    const std::string all(std::istreambuf_iterator<char>(in), {});
    try {
      RecordsIn(WithChecksums(all));
    } catch (const Error&) {  // the proper answer to damage
    }
    return RecordsIn(ViewOf(all));
  };
  return Accepts(bytes, read, [](std::ostream& out, const std::vector<drivers::LoggedRecord>& records) {
    drivers::LineLogEncoder encoder;
    const auto put = [&](const drivers::Bytes& part) { out << std::string(part.begin(), part.end()); };
    put(encoder.Begin());
    for (const drivers::LoggedRecord& record : records) put(encoder.Add(record));
  });
}

constexpr std::array<Reader, 21> kReaders{{{"uos_cloud", AcceptsUosCloud},
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
                                           {"lms200_payload", AcceptsLms200Payload},
                                           {"dynamixel", AcceptsDynamixel},
                                           {"roboclaw", AcceptsRoboclaw},
                                           {"hobby_servo", AcceptsHobbyServo},
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
