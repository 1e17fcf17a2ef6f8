#include "drivers/hardware/devices/identify.h"

#include <algorithm>
#include <array>

#include "drivers/hardware/dynamixel/packet.h"
#include "drivers/hardware/hobby_servo/maestro.h"
#include "drivers/hardware/lms200/link.h"
#include "drivers/hardware/roboclaw/packet.h"

namespace ariadne::drivers {
namespace {

constexpr std::array<int, 4> kServoRates{57600, 115200, 1000000, 9600};
constexpr std::array<int, 3> kMotorRates{38400, 115200, 460800};
constexpr double kAnswerTime = 0.05;  // beyond what the line needs [s]

/// False where the port has not this rate.
bool HasRate(ByteStream& line, int baud) {
  try {
    line.SetBaud(baud);
    return true;
  } catch (const Error&) {
    return false;
  }
}

/// What comes after a question, of up to `size` bytes.
Bytes Answer(ByteStream& line, const Bytes& question, std::size_t size) {
  line.Read(line.Now());
  line.Write(question);
  const double bytes = static_cast<double>(question.size() + size);
  const double deadline = line.Now() + bytes * 10.0 / line.baud() + kAnswerTime;
  Bytes answer;
  while (line.Now() < deadline) {
    const Bytes more = line.Read(deadline);
    answer.insert(answer.end(), more.begin(), more.end());
  }
  return answer;
}

/// All servos of a bus answer a ping to everybody.
std::optional<FoundDevice> FindServos(ByteStream& line) {
  for (const int baud : kServoRates) {
    if (!HasRate(line, baud)) continue;
    dynamixel::PacketDecoder decoder;
    decoder.Push(Answer(line, dynamixel::EncodePacket(dynamixel::Ping(dynamixel::kBroadcast)), 100));
    std::string servos;
    while (const std::optional<dynamixel::Packet> packet = decoder.Next()) {
      const bool status = packet->instruction == static_cast<std::uint8_t>(dynamixel::Instruction::kStatus);
      if (!status || packet->parameters.size() != 4) continue;
      const int model = packet->parameters[1] | packet->parameters[2] << 8;
      servos += fmt::format("{}id {} (model {})", servos.empty() ? "" : ", ", packet->id, model);
    }
    if (!servos.empty()) return FoundDevice{DeviceKind::kDynamixel, baud, servos};
  }
  return std::nullopt;
}

/// The boards' addresses are 0x80 to 0x87; they keep silent to others.
std::optional<FoundDevice> FindMotors(ByteStream& line) {
  using roboclaw::Code;
  for (const int baud : kMotorRates) {
    if (!HasRate(line, baud)) continue;
    for (int address = 0x80; address <= 0x87; ++address) {
      const auto number = static_cast<std::uint8_t>(address);
      const Bytes answer =
          Answer(line, roboclaw::EncodeRequest(number, Code::kVersion), roboclaw::kLongestVersion);
      try {
        const std::optional<Bytes> version = roboclaw::DecodeReply(number, Code::kVersion, answer);
        if (!version) continue;
        const std::string text(version->begin(),
                               std::find(version->begin(), version->end(), std::uint8_t{'\n'}));
        return FoundDevice{DeviceKind::kRoboclaw, baud, fmt::format("{}, address {}", text, address)};
      } catch (const Error&) {
        continue;  // not a board's answer
      }
    }
  }
  return std::nullopt;
}

/// The pulse of a channel [us], 0 for none; none for what no controller says. Channels can be inputs too.
std::optional<double> PulseOfChannel(ByteStream& line, std::uint8_t channel) {
  const Bytes answer =
      Answer(line, hobby_servo::EncodeRequest({hobby_servo::Code::kPosition, channel, 0}), 2);
  if (answer.size() != 2) return std::nullopt;
  constexpr int kLargestInput = 1023, kShortest = 1600, kLongest = 11200;  // [0.25 us]
  const int number = hobby_servo::NumberOf(answer);
  if (number > kLongest || (number > kLargestInput && number < kShortest)) return std::nullopt;
  return number * 0.25;
}

/// Its answers have no checksum: two channels must say what can be. The first byte of all lets a controller
/// find its rate that is set to do so.
std::optional<FoundDevice> FindServoController(ByteStream& line) {
  constexpr int kRate = 9600;
  if (!HasRate(line, kRate)) return std::nullopt;
  Answer(line, hobby_servo::EncodeRequest({hobby_servo::Code::kDetectBaud, 0, 0}), 0);
  const std::optional<double> first = PulseOfChannel(line, 0);
  const std::optional<double> second = first ? PulseOfChannel(line, 1) : std::nullopt;
  if (!second) return std::nullopt;
  return FoundDevice{DeviceKind::kMaestro, kRate,
                     fmt::format("pulses of channel 0: {:.0f} us, 1: {:.0f} us", *first, *second)};
}

std::optional<FoundDevice> FindScanner(ByteStream& line) {
  lms200::Link link(line);
  for (const int baud : lms200::kBaudRates) {
    if (!HasRate(line, baud)) continue;
    const auto arrived = link.Ask(lms200::CommandOf(lms200::Code::kType), 0.1, 2);
    if (!arrived) continue;
    return FoundDevice{DeviceKind::kLms200, baud, std::get<lms200::TypeReply>(arrived->reply).type};
  }
  return std::nullopt;
}

}  // namespace

std::optional<FoundDevice> IdentifyDevice(ByteStream& line) {
  if (std::optional<FoundDevice> scanner = FindScanner(line)) return scanner;
  if (std::optional<FoundDevice> motors = FindMotors(line)) return motors;
  if (std::optional<FoundDevice> servos = FindServos(line)) return servos;
  return FindServoController(line);
}

std::vector<DeviceListing> ListDevices(const std::vector<SerialPortName>& ports) {
  std::vector<DeviceListing> listings;
  for (const SerialPortName& port : ports) {
    DeviceListing& listing = listings.emplace_back();
    listing.port = port;
    try {
      const std::unique_ptr<ByteStream> line = OpenSerialPort(port.path, 9600);
      listing.device = IdentifyDevice(*line);
    } catch (const Error& error) {
      listing.problem = error.what();
    }
  }
  return listings;
}

}  // namespace ariadne::drivers
