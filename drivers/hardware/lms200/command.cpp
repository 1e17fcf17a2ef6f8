#include "drivers/hardware/lms200/command.h"

#include <algorithm>
#include <array>

namespace ariadne::drivers::lms200 {
namespace {

constexpr std::array<Code, 14> kCodes{
    Code::kReset,        Code::kMode,          Code::kScan,       Code::kStatus,     Code::kErrors,
    Code::kMean,         Code::kSubrange,      Code::kType,       Code::kVariant,    Code::kMeanSubrange,
    Code::kReflectivity, Code::kPermanentBaud, Code::kReadConfig, Code::kWriteConfig};

template <typename Io, typename C>
void RangeFields(Io& io, C& command) {
  io.Word(command.first);
  io.Word(command.last);
}

template <typename Io, typename C>
void ModeFields(Io& io, C& command) {
  const Mode mode = command.mode;
  if (mode == Mode::kStreamMean || mode == Mode::kStreamMeanSubrange) io.Byte(command.samples);
  if (mode == Mode::kStreamSubrange || mode == Mode::kStreamMeanSubrange || mode == Mode::kStreamFields ||
      mode == Mode::kStreamReflectivity) {
    RangeFields(io, command);
  }
  io.Rest(command.data);
}

/// The parameters of a command behind its code; modes have their number read or written before.
template <typename Io, typename C>
void ParameterFields(Io& io, C& command) {
  switch (command.code) {
    case Code::kMode:
      return ModeFields(io, command);
    case Code::kMean:
      return io.Byte(command.samples);
    case Code::kMeanSubrange:
      io.Byte(command.samples);
      return RangeFields(io, command);
    case Code::kSubrange:
    case Code::kReflectivity:
      return RangeFields(io, command);
    case Code::kVariant:
      io.Word(command.angle);
      return io.Word(command.resolution);
    case Code::kWriteConfig:
      return io.Rest(command.data);
    default:
      return;
  }
}

}  // namespace

bool IsCommand(std::uint8_t code) {
  return std::find(kCodes.begin(), kCodes.end(), static_cast<Code>(code)) != kCodes.end();
}

Bytes EncodeCommand(const Command& command) {
  WireWriter writer;
  writer.Byte(static_cast<std::uint8_t>(command.code));
  if (command.code == Code::kMode) writer.Byte(static_cast<std::uint8_t>(command.mode));
  if (command.code == Code::kScan) writer.Byte(1);  // the number of sweeps, of which 1 is documented
  if (command.code == Code::kPermanentBaud) writer.Byte(command.permanent ? 1 : 0);
  ParameterFields(writer, command);
  return writer.Finish();
}

Command DecodeCommand(ByteView payload) {
  WireReader reader(payload);
  std::uint8_t byte = 0;
  reader.Byte(byte);
  if (!IsCommand(byte)) Fail("the LMS-200 has no command 0x{:02X}", byte);
  Command command;
  command.code = static_cast<Code>(byte);
  if (command.code == Code::kMode) {
    reader.Byte(byte);
    command.mode = static_cast<Mode>(byte);
  }
  if (command.code == Code::kScan) {
    reader.Byte(byte);
    if (byte != 1) Fail("command 0x30 of the LMS-200 asks for one sweep, not for {}", byte);
  }
  if (command.code == Code::kPermanentBaud) {
    reader.Byte(byte);
    if (byte > 1) Fail("command 0x66 of the LMS-200 carries 0 or 1, not {}", byte);
    command.permanent = byte == 1;
  }
  ParameterFields(reader, command);
  reader.Finish();
  return command;
}

Command CommandOf(Code code) {
  Command command;
  command.code = code;
  return command;
}

Command ModeCommand(Mode mode) {
  Command command = CommandOf(Code::kMode);
  command.mode = mode;
  return command;
}

Command PasswordCommand(std::string_view password) {
  Command command = ModeCommand(Mode::kInstallation);
  command.data.assign(password.begin(), password.end());
  return command;
}

Command VariantCommand(const Variant& variant) {
  Command command = CommandOf(Code::kVariant);
  command.angle = variant.field_of_view;
  command.resolution = variant.resolution;
  return command;
}

}  // namespace ariadne::drivers::lms200
