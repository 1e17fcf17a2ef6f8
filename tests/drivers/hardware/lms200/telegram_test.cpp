#include "drivers/hardware/lms200/telegram.h"

#include <gtest/gtest.h>

#include "drivers/hardware/lms200/telegram_decoder.h"
#include "slam/base/error.h"
#include "tests/drivers/hardware/lms200/samples.h"

namespace ariadne::drivers::lms200 {
namespace {

/// The vectors of spec 9.1, and which command each is.
struct CommandVector {
  const char* hex;
  Command command;
};

std::vector<CommandVector> CommandVectors() {
  return {{"02 00 01 00 31 15 12", CommandOf(Code::kStatus)},
          {"02 00 02 00 20 24 34 08", ModeCommand(Mode::kStream)},
          {"02 00 02 00 20 25 35 08", ModeCommand(Mode::kOnRequest)},
          {"02 00 02 00 20 40 50 08", ModeCommand(ModeOfBaud(38400))},
          {"02 00 02 00 20 41 51 08", ModeCommand(ModeOfBaud(19200))},
          {"02 00 02 00 20 42 52 08", ModeCommand(ModeOfBaud(9600))},
          {"02 00 02 00 20 48 58 08", ModeCommand(ModeOfBaud(500000))},
          {"02 00 05 00 3B B4 00 64 00 97 49", VariantCommand({180, 100})},
          {"02 00 05 00 3B B4 00 32 00 3B 1F", VariantCommand({180, 50})},
          {"02 00 05 00 3B 64 00 19 00 E7 72", VariantCommand({100, 25})},
          {"02 00 02 00 30 01 31 18", CommandOf(Code::kScan)},
          {"02 00 0A 00 20 00 53 49 43 4B 5F 4C 4D 53 BE C5", PasswordCommand()},
          {"02 00 01 00 74 50 12", CommandOf(Code::kReadConfig)},
          {"02 00 01 00 3A 1E 12", CommandOf(Code::kType)},
          {"02 00 01 00 10 34 12", CommandOf(Code::kReset)}};
}

std::vector<Received> DecodeAll(Sender sender, ByteView bytes) {
  TelegramDecoder decoder(sender);
  decoder.Push(bytes);
  std::vector<Received> all;
  while (std::optional<Received> next = decoder.Next()) all.push_back(*next);
  return all;
}

TEST(Lms200Telegram, IsEncodedAsPublished) {
  for (const CommandVector& vector : CommandVectors()) {
    EXPECT_EQ(FrameOf(vector.command), FromHex(vector.hex)) << vector.hex;
  }
  EXPECT_EQ(FrameOf(Reply(ModeReply{})), FromHex("02 80 03 00 A0 00 10 16 0A"));
}

TEST(Lms200Telegram, IsDecodedAsPublished) {
  for (const CommandVector& vector : CommandVectors()) {
    const std::vector<Received> all = DecodeAll(Sender::kHost, FromHex(vector.hex));
    ASSERT_EQ(all.size(), 1U) << vector.hex;
    EXPECT_EQ(DecodeCommand(all[0].telegram.payload), vector.command) << vector.hex;
  }
  const std::vector<Received> reply = DecodeAll(Sender::kDevice, FromHex("02 80 03 00 A0 00 10 16 0A"));
  ASSERT_EQ(reply.size(), 1U);
  EXPECT_EQ(DecodeReply(reply[0].telegram.payload), Reply(ModeReply{}));
}

TEST(Lms200Telegram, HasSizesOfTheSpec) {
  MeasuredValues values;
  values.words.resize(181);
  EXPECT_EQ(FrameOf(Reply(values)).size(), 372U);
  values.words.resize(361);
  EXPECT_EQ(FrameOf(Reply(values)).size(), 732U);
  EXPECT_EQ(FrameOf(Reply(StatusReply{})).size(), 160U);
}

TEST(Lms200Telegram, CarriesNeitherNothingNorTooMuch) {
  EXPECT_NO_THROW(EncodeTelegram({0, Bytes(812)}));
  EXPECT_THROW(EncodeTelegram({0, Bytes(813)}), Error);
  EXPECT_THROW(EncodeTelegram({0, {}}), Error);
}

/// Each single byte, whatever it becomes, and each single bit.
TEST(Lms200Telegram, WithOneWrongByteIsNeverAccepted) {
  RandomStream stream = NamedStream(1, "wrong byte");
  for (int round = 0; round < 60; ++round) {
    const Bytes frame = FrameOf(AnyReply(stream, static_cast<std::uint32_t>(round) % kReplyKinds));
    for (std::size_t at = 0; at < frame.size(); ++at) {
      Bytes wrong = frame;
      wrong[at] ^= static_cast<std::uint8_t>(Draw(stream, 1, 255));
      for (const Received& received : DecodeAll(Sender::kDevice, wrong)) {
        EXPECT_NE(received.kind, Received::Kind::kTelegram) << "byte " << at;
      }
    }
  }
}

/// What the docstring of Crc warns of: it is a fact of the device's checksum, not of this program.
TEST(Lms200Telegram, HidesTwoWrongBitsOnADiagonal) {
  Bytes bytes = FromHex("02 80 03 00 A0 00 10");
  const std::uint16_t crc = Crc(bytes);
  bytes[4] ^= 0x04;
  EXPECT_NE(Crc(bytes), crc);
  bytes[5] ^= 0x08;
  EXPECT_EQ(Crc(bytes), crc);
}

}  // namespace
}  // namespace ariadne::drivers::lms200
