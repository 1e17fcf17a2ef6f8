#pragma once

#include <string_view>

#include "drivers/hardware/lms200/types.h"
#include "drivers/hardware/wire.h"

namespace ariadne::drivers::lms200 {

/// One command of the host with its parameters, of which each code has those that its line names; the
/// others keep their defaults.
struct Command {
  Code code = Code::kStatus;
  Mode mode = Mode::kOnRequest;  // kMode
  std::uint8_t samples = 0;      // kMean, kMeanSubrange, kStreamMean, kStreamMeanSubrange: sweeps in a mean
  std::uint16_t first = 0;  // beams from 1 on, both included: kSubrange, kMeanSubrange, kReflectivity and
  std::uint16_t last = 0;   // the streams of subranges, fields and reflectivity
  std::uint16_t angle = 0;  // kVariant [deg]
  std::uint16_t resolution = 0;  // kVariant [0.01 deg]
  bool permanent = false;        // kPermanentBaud: the rate of now is also that of the next power-on
  Bytes data;                    // kWriteConfig; the password of kInstallation; what other modes carry

  bool operator==(const Command&) const = default;
};

/// The payload of a command's telegram.
Bytes EncodeCommand(const Command& command);

/// Error if it is no command of the table, or too long or too short for one.
Command DecodeCommand(ByteView payload);

/// Whether there is such a command, whatever its parameters.
bool IsCommand(std::uint8_t code);

Command CommandOf(Code code);
Command ModeCommand(Mode mode);
Command PasswordCommand(std::string_view password = kPassword);
Command VariantCommand(const Variant& variant);

}  // namespace ariadne::drivers::lms200
