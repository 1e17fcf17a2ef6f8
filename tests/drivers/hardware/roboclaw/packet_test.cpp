#include "drivers/hardware/roboclaw/packet.h"

#include <gtest/gtest.h>

#include <string>

#include "slam/base/error.h"
#include "tests/drivers/hardware/lms200/samples.h"

namespace ariadne::drivers::roboclaw {
namespace {

using lms200::Draw;
using lms200::DrawBytes;
using lms200::FromHex;

/// Polynomial 0x1021 from 0, highest bit first, is CRC-16/XMODEM, whose check value is known.
TEST(RoboclawPacket, HasTheChecksumOfTheManual) {
  const std::string digits = "123456789";
  EXPECT_EQ(Crc(Bytes(digits.begin(), digits.end())), 0x31C3);
}

TEST(RoboclawPacket, TravelsWithTheHighestByteFirst) {
  EXPECT_EQ(EncodeRequest(0x80, Code::kEncoders), FromHex("80 4E"));
  Bytes data;
  PutNumber(data, 0x01020304, 4);
  PutNumber(data, static_cast<std::uint32_t>(-2), 4);
  const Bytes request = EncodeRequest(0x80, Code::kSpeeds, data);
  EXPECT_EQ(Bytes(request.begin(), request.end() - 2), FromHex("80 25 01 02 03 04 FF FF FF FE"));
  EXPECT_EQ(NumberAt(request, 10, 2), Crc(ByteView(request).first(10)));
  EXPECT_THROW(EncodeRequest(0x80, Code::kSpeeds, {1, 2}), Error);
}

TEST(RoboclawPacket, ReadsWhatWasReplied) {
  const Bytes data = FromHex("00 00 01 00 FF FF FF 00");
  const Bytes reply = EncodeReply(0x80, Code::kEncoders, data);
  EXPECT_EQ(DecodeReply(0x80, Code::kEncoders, reply), data);
  EXPECT_FALSE(DecodeReply(0x80, Code::kEncoders, ByteView(reply).first(9)));
  for (std::size_t bit = 0; bit < 8 * reply.size(); ++bit) {
    Bytes wrong = reply;
    wrong[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
    EXPECT_THROW(DecodeReply(0x80, Code::kEncoders, wrong), Error);
  }
  EXPECT_THROW(DecodeReply(0x81, Code::kEncoders, reply), Error);        // of another board
  EXPECT_THROW(DecodeReply(0x80, Code::kMeasuredSpeeds, reply), Error);  // to another question
  const Bytes version = {'v', '4', '\n', '\0'};
  EXPECT_EQ(DecodeReply(0x80, Code::kVersion, EncodeReply(0x80, Code::kVersion, version)), version);
  EXPECT_FALSE(DecodeReply(0x80, Code::kVersion, Bytes{'v'}));
  EXPECT_THROW(DecodeReply(0x80, Code::kVersion, Bytes(50, 'v')), Error);
}

TEST(RoboclawRequests, AreFoundHoweverTheStreamIsCut) {
  RandomStream stream = NamedStream(1, "requests");
  for (int round = 0; round < 100; ++round) {
    Bytes bytes;
    int sent = 0;
    for (int i = 0; i < 10; ++i) {
      const Code code = Draw(stream, 0, 1) == 0 ? Code::kSpeedsWithAcceleration : Code::kStatus;
      const Bytes garbage(Draw(stream, 0, 5), 0x11);
      bytes.insert(bytes.end(), garbage.begin(), garbage.end());
      const Bytes data = code == Code::kStatus ? Bytes{} : DrawBytes(stream, 12);
      const Bytes request = EncodeRequest(0x80, code, data);
      bytes.insert(bytes.end(), request.begin(), request.end());
      ++sent;
    }
    RequestDecoder decoder(0x80);
    int found = 0;
    for (const std::uint8_t byte : bytes) {
      decoder.Push(ByteView(&byte, 1));
      while (decoder.Next()) ++found;
    }
    EXPECT_EQ(found, sent);
  }
}

TEST(RoboclawRequests, WithAWrongByteAreNotCarriedOut) {
  RandomStream stream = NamedStream(2, "wrong requests");
  for (int i = 0; i < 2000; ++i) {
    Bytes bytes = EncodeRequest(0x80, Code::kSpeeds, Bytes(8, 0x05));
    bytes[Draw(stream, 2, 11)] ^= static_cast<std::uint8_t>(1U << Draw(stream, 0, 7));
    RequestDecoder decoder(0x80);
    decoder.Push(bytes);
    EXPECT_FALSE(decoder.Next());
  }
}

}  // namespace
}  // namespace ariadne::drivers::roboclaw
