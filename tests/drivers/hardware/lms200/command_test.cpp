#include "drivers/hardware/lms200/command.h"

#include <gtest/gtest.h>

#include "slam/base/error.h"
#include "tests/drivers/hardware/lms200/samples.h"

namespace ariadne::drivers::lms200 {
namespace {

Command Of(Code code, Mode mode, std::uint8_t samples, std::uint16_t first, std::uint16_t last,
           Bytes data = {}) {
  Command command = CommandOf(code);
  command.mode = mode;
  command.samples = samples;
  command.first = first;
  command.last = last;
  command.data = std::move(data);
  return command;
}

/// Each command and mode of spec 9.2 with its bytes, written down by hand.
TEST(Lms200Command, TravelsAsTheTableSays) {
  Command permanent = CommandOf(Code::kPermanentBaud);
  permanent.permanent = true;
  constexpr Mode kNone = Mode::kOnRequest;
  const std::vector<std::pair<Command, const char*>> table = {
      {CommandOf(Code::kErrors), "32"},
      {Of(Code::kMean, kNone, 5, 0, 0), "36 05"},
      {Of(Code::kSubrange, kNone, 0, 0x5B, 0x16A), "37 5B 00 6A 01"},
      {Of(Code::kMeanSubrange, kNone, 9, 2, 0x101), "3F 09 02 00 01 01"},
      {Of(Code::kReflectivity, kNone, 0, 1, 181), "44 01 00 B5 00"},
      {permanent, "66 01"},
      {CommandOf(Code::kPermanentBaud), "66 00"},
      {Of(Code::kWriteConfig, kNone, 0, 0, 0, Bytes{1, 2, 3}), "77 01 02 03"},
      {ModeCommand(Mode::kDiagnostic), "20 10"},
      {Of(Code::kMode, Mode::kStreamMean, 4, 0, 0), "20 26 04"},
      {Of(Code::kMode, Mode::kStreamSubrange, 0, 1, 2), "20 27 01 00 02 00"},
      {Of(Code::kMode, Mode::kStreamMeanSubrange, 3, 1, 2), "20 28 03 01 00 02 00"},
      {Of(Code::kMode, Mode::kStreamFields, 0, 1, 2), "20 29 01 00 02 00"},
      {ModeCommand(Mode::kStreamPartial), "20 2A"},
      {Of(Code::kMode, Mode::kSomePartial, 0, 0, 0, Bytes{4}), "20 2B 04"},
      {Of(Code::kMode, static_cast<Mode>(0x2C), 0, 0, 0), "20 2C"},
      {Of(Code::kMode, static_cast<Mode>(0x2E), 0, 0, 0), "20 2E"},
      {Of(Code::kMode, Mode::kStreamReflectivity, 0, 1, 181), "20 50 01 00 B5 00"},
  };
  for (const auto& [command, hex] : table) {
    EXPECT_EQ(EncodeCommand(command), FromHex(hex)) << hex;
    EXPECT_EQ(DecodeCommand(FromHex(hex)), command) << hex;
  }
}

TEST(Lms200Command, IsRefusedWhenItIsNone) {
  for (const char* hex : {"11", "00", "20", "30", "30 02", "31 00", "36", "37 01 00 02", "3B B4 00 64",
                          "3B B4 00 64 00 00", "66", "66 02", "20 26", "20 27 01 00 02"}) {
    EXPECT_THROW(DecodeCommand(FromHex(hex)), Error) << hex;
  }
  EXPECT_THROW(DecodeCommand({}), Error);
  EXPECT_THROW(ModeOfBaud(115200), Error);
}

}  // namespace
}  // namespace ariadne::drivers::lms200
