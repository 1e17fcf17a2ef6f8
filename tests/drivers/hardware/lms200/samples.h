#pragma once

#include <string>
#include <vector>

#include "drivers/hardware/lms200/command.h"
#include "drivers/hardware/lms200/reply.h"
#include "drivers/hardware/lms200/telegram.h"
#include "slam/base/random.h"

namespace ariadne::drivers::lms200 {

/// "02 00 01" -> bytes.
inline Bytes FromHex(const std::string& text) {
  Bytes bytes;
  for (std::size_t i = 0; i + 1 < text.size(); i += 3) {
    bytes.push_back(static_cast<std::uint8_t>(std::stoi(text.substr(i, 2), nullptr, 16)));
  }
  return bytes;
}

inline std::uint32_t Draw(RandomStream& stream, std::uint32_t low, std::uint32_t high) {
  return low + static_cast<std::uint32_t>(stream() % (high - low + 1));
}
inline std::uint8_t DrawByte(RandomStream& stream) { return static_cast<std::uint8_t>(stream() & 0xFF); }

inline Bytes DrawBytes(RandomStream& stream, std::size_t count) {
  Bytes bytes(count);
  for (std::uint8_t& byte : bytes) byte = DrawByte(stream);
  return bytes;
}

inline MeasuredValues AnyValues(RandomStream& stream) {
  MeasuredValues values;
  values.code = std::vector<std::uint8_t>{0xB0, 0xB6, 0xB7, 0xBF, 0xC4}[Draw(stream, 0, 4)];
  values.unit = static_cast<LengthUnit>(Draw(stream, 0, 1));
  values.partial = values.code == 0xB0 && Draw(stream, 0, 1) == 1;
  values.offset = values.partial ? static_cast<int>(Draw(stream, 0, 3)) : 0;
  std::size_t count = std::vector<std::size_t>{101, 181, 201, 361}[Draw(stream, 0, 3)];
  if (values.partial) count = (Draw(stream, 0, 1) == 0 ? 101U : 181U) - (values.offset == 0 ? 0U : 1U);
  if (values.code == 0xB6 || values.code == 0xBF) values.samples = DrawByte(stream);
  if (values.code == 0xB7 || values.code == 0xBF || values.code == 0xC4) {
    if (values.code == 0xC4) count = 181;
    values.first = static_cast<std::uint16_t>(Draw(stream, 1, static_cast<std::uint32_t>(count)));
    values.last = static_cast<std::uint16_t>(Draw(stream, values.first, static_cast<std::uint32_t>(count)));
    const std::size_t beams = values.last - values.first + 1U;
    if (values.code == 0xC4) {
      values.reflectivity = DrawBytes(stream, beams);
    } else {
      count = beams;
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    values.words.push_back(static_cast<std::uint16_t>(Draw(stream, 0, 0xFFFF)));
  }
  if (Draw(stream, 0, 1) == 1) values.indices = RealTimeIndices{DrawByte(stream), DrawByte(stream)};
  values.status = DrawByte(stream);
  return values;
}

inline StatusReply AnyStatus(RandomStream& stream) {
  StatusReply status;
  status.software = "V02.30 ";
  status.mode = static_cast<Mode>(DrawByte(stream));
  status.error = DrawByte(stream);
  status.type = DrawByte(stream);
  status.motor_revolutions = static_cast<std::uint16_t>(Draw(stream, 0, 0xFFFF));
  status.measuring_mode = MeasuringMode::k16mReflector;
  status.variant = {100, 25};
  status.baud = kBaudRates[Draw(stream, 0, 3)];
  status.permanent_baud = Draw(stream, 0, 1) == 1;
  status.address = DrawByte(stream);
  status.unit = LengthUnit::kMillimetre;
  status.laser_on = Draw(stream, 0, 1) == 1;
  status.boot_prom = "X01.27";
  status.status = DrawByte(stream);
  return status;
}

/// One of each kind, over and over: of number 0 to 10.
inline Reply AnyReply(RandomStream& stream, std::uint32_t kind) {
  const std::uint8_t status = DrawByte(stream);
  const bool ok = Draw(stream, 0, 1) == 1;
  const Config config = WithRealTimeIndices(FactoryConfig(ok ? kConfigSize : kOldConfigSize), ok);
  switch (kind) {
    case 0:
      return PowerOn{"LMS200;30106;V02.30", status};
    case 1:
      return Notice{static_cast<std::uint8_t>(ok ? kResetConfirmed : kUnknownCommand), status};
    case 2:
      return ModeReply{static_cast<ModeAnswer>(Draw(stream, 0, 2)), status};
    case 3:
      return ErrorReply{{{1, DrawByte(stream)}, {DrawByte(stream), 7}}, status};
    case 4:
      return TypeReply{"LMS200;30106x;V02.10", status};
    case 5:
      return VariantReply{ok, 100, static_cast<std::uint16_t>(Draw(stream, 0, 100)), status};
    case 6:
      return PermanentBaudReply{ok, status};
    case 7:
      return ConfigReply{config, status};
    case 8:
      return WrittenReply{ok, config, status};
    case 9:
      return AnyStatus(stream);
    default:
      return AnyValues(stream);
  }
}
constexpr std::uint32_t kReplyKinds = 11;

inline Bytes FrameOf(const Reply& reply) { return EncodeTelegram({kFromDevice, EncodeReply(reply)}); }
inline Bytes FrameOf(const Command& command) { return EncodeTelegram({0, EncodeCommand(command)}); }

}  // namespace ariadne::drivers::lms200
