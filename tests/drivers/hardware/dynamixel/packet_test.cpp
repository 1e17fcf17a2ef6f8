#include "drivers/hardware/dynamixel/packet.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "slam/base/error.h"
#include "slam/base/random.h"
#include "tests/drivers/hardware/lms200/samples.h"

namespace ariadne::drivers::dynamixel {
namespace {

using lms200::Draw;
using lms200::DrawBytes;
using lms200::FromHex;

/// The examples of the manufacturer's manual of protocol 2.0.
TEST(DynamixelPacket, TravelsAsPublished) {
  const std::vector<std::pair<Packet, const char*>> examples = {
      {Ping(1), "FF FF FD 00 01 03 00 01 19 4E"},
      {{1, 0x55, {0x00, 0x06, 0x04, 0x26}}, "FF FF FD 00 01 07 00 55 00 06 04 26 65 5D"},
      {Read(1, 132, 4), "FF FF FD 00 01 07 00 02 84 00 04 00 1D 15"},
      {{1, 0x55, {0x00, 0xA6, 0x00, 0x00, 0x00}}, "FF FF FD 00 01 08 00 55 00 A6 00 00 00 8C C0"},
      {Write(1, 116, Bytes{0x00, 0x02, 0x00, 0x00}), "FF FF FD 00 01 09 00 03 74 00 00 02 00 00 CA 89"},
      {{1, 0x55, {0x00}}, "FF FF FD 00 01 04 00 55 00 A1 0C"},
      {Reboot(1), "FF FF FD 00 01 03 00 08 2F 4E"}};
  for (const auto& [packet, hex] : examples) {
    EXPECT_EQ(EncodePacket(packet), FromHex(hex)) << hex;
    PacketDecoder decoder;
    decoder.Push(FromHex(hex));
    EXPECT_EQ(decoder.Next(), packet) << hex;
  }
}

TEST(DynamixelPacket, WritesSeveralAtOnce) {
  const Packet packet = SyncWrite(116, {{1, {1, 2, 3, 4}}, {2, {5, 6, 7, 8}}});
  EXPECT_EQ(packet.id, kBroadcast);
  EXPECT_EQ(packet.parameters, FromHex("74 00 04 00 01 01 02 03 04 02 05 06 07 08"));
  EXPECT_THROW(SyncWrite(116, {{1, {1}}, {2, {5, 6}}}), Error);
}

/// Parameters that look like headers, in all ways.
Packet AnyPacket(RandomStream& stream) {
  Packet packet{static_cast<std::uint8_t>(Draw(stream, 0, 254)),
                static_cast<std::uint8_t>(Draw(stream, 1, 0x83)), DrawBytes(stream, Draw(stream, 0, 40))};
  for (std::uint8_t& byte : packet.parameters) {
    if (Draw(stream, 0, 1) == 0) byte = Bytes{0xFF, 0xFF, 0xFD, 0x00}[Draw(stream, 0, 3)];
  }
  return packet;
}

TEST(DynamixelPacket, HasNoHeaderWithin) {
  RandomStream stream = NamedStream(1, "stuffing");
  const Bytes header = {0xFF, 0xFF, 0xFD, 0x00};
  for (int i = 0; i < 2000; ++i) {
    const Packet packet = AnyPacket(stream);
    const Bytes bytes = EncodePacket(packet);
    EXPECT_EQ(std::search(bytes.begin() + 7, bytes.end() - 2, header.begin(), header.end()),
              bytes.end() - 2);
    PacketDecoder decoder;
    decoder.Push(bytes);
    EXPECT_EQ(decoder.Next(), packet);
  }
  EXPECT_THROW(EncodePacket({1, 3, Bytes(1100)}), Error);
}

TEST(DynamixelDecoder, FindsTheSameHoweverTheStreamIsCut) {
  RandomStream stream = NamedStream(2, "cuts");
  for (int round = 0; round < 100; ++round) {
    Bytes bytes;
    std::vector<Packet> sent;
    for (int i = 0; i < 10; ++i) {
      const Bytes garbage(Draw(stream, 0, 9), Draw(stream, 0, 1) == 0 ? 0xFF : 0x01);
      bytes.insert(bytes.end(), garbage.begin(), garbage.end());
      sent.push_back(AnyPacket(stream));
      const Bytes packet = EncodePacket(sent.back());
      bytes.insert(bytes.end(), packet.begin(), packet.end());
    }
    std::vector<Packet> found;
    PacketDecoder decoder;
    for (std::size_t at = 0; at < bytes.size();) {
      const std::size_t size = std::min<std::size_t>(Draw(stream, 1, 30), bytes.size() - at);
      decoder.Push(ByteView(bytes).subspan(at, size));
      while (const std::optional<Packet> packet = decoder.Next()) found.push_back(*packet);
      at += size;
    }
    EXPECT_EQ(found, sent) << "round " << round;
  }
}

TEST(DynamixelDecoder, NeverAcceptsOneWrongByteOrTwoWrongBits) {
  RandomStream stream = NamedStream(3, "flips");
  for (int i = 0; i < 3000; ++i) {
    Bytes bytes = EncodePacket(AnyPacket(stream));
    const std::uint32_t last = static_cast<std::uint32_t>(bytes.size()) - 1;
    if (Draw(stream, 0, 1) == 0) {
      bytes[Draw(stream, 0, last)] ^= static_cast<std::uint8_t>(Draw(stream, 1, 255));
    } else {
      const std::uint32_t bit = Draw(stream, 0, 8 * last);
      bytes[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
      bytes[(bit + 1) / 8] ^= static_cast<std::uint8_t>(1U << ((bit + 1) % 8));
    }
    PacketDecoder decoder;
    decoder.Push(bytes);
    EXPECT_FALSE(decoder.Next());
  }
}

}  // namespace
}  // namespace ariadne::drivers::dynamixel
