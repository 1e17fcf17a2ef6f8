#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "drivers/hardware/lms200/config.h"
#include "drivers/hardware/lms200/status.h"
#include "drivers/hardware/lms200/values.h"

namespace ariadne::drivers::lms200 {

/// 0x90 after a reset or with power; text of the type, as 0x3A gives it.
struct PowerOn {
  std::string type;
  std::uint8_t status = 0x10;
  bool operator==(const PowerOn&) const = default;
};
/// 0x91: the device is about to restart. 0x92: it does not know the command.
struct Notice {
  std::uint8_t code = kResetConfirmed;
  std::uint8_t status = 0x10;
  bool operator==(const Notice&) const = default;
};
/// 0xA0.
struct ModeReply {
  ModeAnswer answer = ModeAnswer::kOk;
  std::uint8_t status = 0x10;
  bool operator==(const ModeReply&) const = default;
};
/// 0xB2: the error memory.
struct ErrorReply {
  struct Entry {
    std::uint8_t type = 0;
    std::uint8_t number = 0;
    bool operator==(const Entry&) const = default;
  };
  std::vector<Entry> entries;
  std::uint8_t status = 0x10;
  bool operator==(const ErrorReply&) const = default;
};
/// 0xBA: for example `LMS200;30106x;V02.10`.
struct TypeReply {
  std::string type;
  std::uint8_t status = 0x10;
  bool operator==(const TypeReply&) const = default;
};
/// 0xBB: the variant that is set now.
struct VariantReply {
  bool ok = true;
  std::uint16_t angle = 180;       // [deg]
  std::uint16_t resolution = 100;  // [0.01 deg]
  std::uint8_t status = 0x10;
  bool operator==(const VariantReply&) const = default;
};
/// 0xE6. The spec does not give its data; as for 0xF7, 1 stands for ok and 0 for refused.
struct PermanentBaudReply {
  bool ok = true;
  std::uint8_t status = 0x10;
  bool operator==(const PermanentBaudReply&) const = default;
};
/// 0xF4: the configuration; 0xF7: what was written, and whether it was.
struct ConfigReply {
  Config config;
  std::uint8_t status = 0x10;
  bool operator==(const ConfigReply&) const = default;
};
struct WrittenReply {
  bool ok = true;
  Config config;
  std::uint8_t status = 0x10;
  bool operator==(const WrittenReply&) const = default;
};

using Reply = std::variant<PowerOn, Notice, ModeReply, ErrorReply, TypeReply, VariantReply,
                           PermanentBaudReply, ConfigReply, WrittenReply, StatusReply, MeasuredValues>;

/// The payload of a reply's telegram.
Bytes EncodeReply(const Reply& reply);

/// Error if it is no reply of the table, or says what the device cannot say.
Reply DecodeReply(ByteView payload);

}  // namespace ariadne::drivers::lms200
