#include <fmt/format.h>

#include <cstdint>
#include <optional>
#include <string_view>

#include "drivers/hardware/devices/line_telegrams.h"
#include "drivers/hardware/dynamixel/servo.h"

namespace ariadne::drivers {
namespace {

using dynamixel::Instruction;
using dynamixel::Packet;
using dynamixel::Place;

std::uint32_t NumberAtEnd(ByteView bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t i = at; i < bytes.size() && i < at + 4; ++i)
    number |= static_cast<std::uint32_t>(bytes[i]) << (8 * (i - at));
  return number;
}

std::string NameOfPlace(std::uint32_t address) {
  switch (static_cast<Place>(address)) {
    case Place::kOperatingMode:
      return "operating mode";
    case Place::kTorqueEnable:
      return "torque";
    case Place::kHardwareError:
      return "hardware error";
    case Place::kProfileAcceleration:
      return "profile acceleration";
    case Place::kProfileVelocity:
      return "profile velocity";
    case Place::kGoalPosition:
      return "goal position";
    case Place::kPresentVelocity:
      return "velocity and position";
    case Place::kPresentPosition:
      return "position";
    default:
      return fmt::format("place {}", address);
  }
}

/// Pairs each status with the question before it, which says what its data are.
class DynamixelTelegramReader : public TelegramReader {
 public:
  std::vector<LineTelegram> Take(const LineRecord& record) override {
    std::vector<LineTelegram> telegrams;
    const bool to_device = record.kind == LineRecord::Kind::kWrite;
    if (!to_device && record.kind != LineRecord::Kind::kRead) return telegrams;
    dynamixel::PacketDecoder& decoder = to_device ? to_device_ : from_device_;
    const std::uint64_t bad = decoder.bad();
    decoder.Push(record.bytes);
    while (const std::optional<Packet> packet = decoder.Next()) {
      const bool status = packet->instruction == static_cast<std::uint8_t>(Instruction::kStatus);
      if (status == to_device) continue;  // an adapter may return what was sent
      LineTelegram telegram{record.time, to_device, false, {}, {}};
      if (to_device) {
        Ask(*packet, telegram);
      } else {
        Answer(*packet, telegram);
      }
      telegrams.push_back(std::move(telegram));
    }
    for (std::uint64_t i = bad; i < decoder.bad(); ++i)
      telegrams.push_back({record.time, to_device, true, "a wrong checksum", {}});
    return telegrams;
  }

 private:
  void Ask(const Packet& packet, LineTelegram& telegram) {
    const ByteView parameters = packet.parameters;
    asked_ = packet;
    telegram.text = fmt::format("to {}: instruction 0x{:02X}", packet.id, packet.instruction);
    if (packet.instruction == static_cast<std::uint8_t>(Instruction::kPing))
      telegram.text = fmt::format("to {}: ping", packet.id);
    if (parameters.size() < 3) return;
    const std::uint32_t address = NumberAtEnd(parameters.first(2), 0);
    if (packet.instruction == static_cast<std::uint8_t>(Instruction::kRead))
      telegram.text = fmt::format("to {}: read {}", packet.id, NameOfPlace(address));
    if (packet.instruction == static_cast<std::uint8_t>(Instruction::kWrite)) {
      telegram.text = fmt::format("to {}: write {} {}", packet.id, NameOfPlace(address),
                                  static_cast<std::int32_t>(NumberAtEnd(parameters, 2)));
    }
  }

  void Answer(const Packet& packet, LineTelegram& telegram) const {
    const ByteView parameters = packet.parameters;
    if (parameters.empty()) {
      telegram.bad = true;
      telegram.text = fmt::format("from {}: an empty answer", packet.id);
      return;
    }
    telegram.bad = (parameters[0] & 0x7F) != 0;
    telegram.text = fmt::format("from {}: {}{}", packet.id,
                                telegram.bad ? fmt::format("error {}", parameters[0] & 0x7F) : "ok",
                                (parameters[0] & 0x80) != 0 ? ", hardware alert" : "");
    const bool state = asked_.instruction == static_cast<std::uint8_t>(Instruction::kRead) &&
                       asked_.id == packet.id && asked_.parameters.size() >= 2 && parameters.size() == 9 &&
                       NumberAtEnd(ByteView(asked_.parameters).first(2), 0) ==
                           static_cast<std::uint32_t>(Place::kPresentVelocity);
    if (!state) return;
    const auto steps = static_cast<std::int32_t>(NumberAtEnd(parameters, 5));
    telegram.text += fmt::format(", position {}", steps);
    telegram.value = LineAngle{steps / static_cast<double>(dynamixel::kStepsPerTurn)};
  }

  dynamixel::PacketDecoder to_device_;
  dynamixel::PacketDecoder from_device_;
  Packet asked_;
};

}  // namespace

std::unique_ptr<TelegramReader> MakeDynamixelReader() {
  return std::make_unique<DynamixelTelegramReader>();
}

}  // namespace ariadne::drivers
