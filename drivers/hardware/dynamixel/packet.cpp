#include "drivers/hardware/dynamixel/packet.h"

#include <array>
#include <boost/crc.hpp>

namespace ariadne::drivers::dynamixel {
namespace {

constexpr std::array<std::uint8_t, 4> kHeader{0xFF, 0xFF, 0xFD, 0x00};
constexpr std::size_t kLengthAt = 5;
constexpr std::size_t kBodyAt = 7;  // instruction and parameters
constexpr std::uint8_t kStuffing = 0xFD;

bool EndsLikeAHeader(const Bytes& bytes, std::size_t from) {
  const std::size_t size = bytes.size();
  return size >= from + 3 && bytes[size - 3] == 0xFF && bytes[size - 2] == 0xFF && bytes[size - 1] == 0xFD;
}

/// The body with an FD after each FF FF FD.
Bytes Stuffed(const Packet& packet) {
  Bytes body = {packet.instruction};
  for (const std::uint8_t byte : packet.parameters) {
    body.push_back(byte);
    if (EndsLikeAHeader(body, 0)) body.push_back(kStuffing);
  }
  return body;
}

/// None if an FF FF FD is not followed by its FD.
std::optional<Bytes> Unstuffed(ByteView body) {
  Bytes plain;
  for (std::size_t i = 0; i < body.size(); ++i) {
    plain.push_back(body[i]);
    if (i < 2 || body[i] != 0xFD || body[i - 1] != 0xFF || body[i - 2] != 0xFF) continue;
    if (++i == body.size() || body[i] != kStuffing) return std::nullopt;
  }
  return plain;
}

std::size_t LengthOf(ByteView packet) {
  return packet[kLengthAt] | static_cast<std::size_t>(packet[kLengthAt + 1]) << 8;
}

}  // namespace

std::uint16_t Crc(ByteView bytes) {
  boost::crc_optimal<16, 0x8005, 0, 0, false, false> crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return static_cast<std::uint16_t>(crc.checksum());
}

Bytes EncodePacket(const Packet& packet) {
  const Bytes body = Stuffed(packet);
  const std::size_t length = body.size() + 2;
  if (length > kMaxLength)
    Fail("a Dynamixel packet carries up to {} bytes, not {}", kMaxLength - 2, body.size());
  WireWriter writer;
  writer.Rest(Bytes(kHeader.begin(), kHeader.end()));
  writer.Byte(packet.id);
  writer.Word(static_cast<std::uint16_t>(length));
  writer.Rest(body);
  Bytes bytes = writer.Finish();
  const std::uint16_t crc = Crc(bytes);
  bytes.push_back(static_cast<std::uint8_t>(crc & 0xFF));
  bytes.push_back(static_cast<std::uint8_t>(crc >> 8));
  return bytes;
}

Packet Ping(std::uint8_t id) { return {id, static_cast<std::uint8_t>(Instruction::kPing), {}}; }

Packet Reboot(std::uint8_t id) { return {id, static_cast<std::uint8_t>(Instruction::kReboot), {}}; }

Packet Read(std::uint8_t id, std::uint16_t address, std::uint16_t count) {
  WireWriter writer;
  writer.Word(address);
  writer.Word(count);
  return {id, static_cast<std::uint8_t>(Instruction::kRead), writer.Finish()};
}

Packet Write(std::uint8_t id, std::uint16_t address, ByteView data) {
  WireWriter writer;
  writer.Word(address);
  writer.Rest(Bytes(data.begin(), data.end()));
  return {id, static_cast<std::uint8_t>(Instruction::kWrite), writer.Finish()};
}

Packet SyncWrite(std::uint16_t address, const std::vector<SyncValue>& values) {
  WireWriter writer;
  writer.Word(address);
  writer.Word(values.empty() ? 0 : static_cast<std::uint16_t>(values.front().data.size()));
  for (const SyncValue& value : values) {
    if (value.data.size() != values.front().data.size()) Fail("a sync write needs data of one size");
    writer.Byte(value.id);
    writer.Rest(value.data);
  }
  return {kBroadcast, static_cast<std::uint8_t>(Instruction::kSyncWrite), writer.Finish()};
}

void PacketDecoder::Push(ByteView bytes) {
  buffer_.erase(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(begin_));
  begin_ = 0;
  buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
}

/// Whether `rest` begins with a packet; each byte is judged as soon as it is there.
PacketDecoder::Found PacketDecoder::Look(ByteView rest) const {
  for (std::size_t i = 0; i < kHeader.size() && i < rest.size(); ++i) {
    if (rest[i] != kHeader[i]) return Found::kNothing;
  }
  if (rest.size() < kBodyAt) return Found::kIncomplete;
  const std::size_t length = LengthOf(rest);
  if (length < 3 || length > kMaxLength) return Found::kNothing;
  const std::size_t crc_at = kBodyAt + length - 2;
  if (rest.size() < crc_at + 2) return Found::kIncomplete;
  const auto crc = static_cast<std::uint16_t>(rest[crc_at] | rest[crc_at + 1] << 8);
  const bool right = Crc(rest.first(crc_at)) == crc && Unstuffed(rest.subspan(kBodyAt, length - 2));
  return right ? Found::kPacket : Found::kBad;
}

std::optional<Packet> PacketDecoder::Next() {
  while (IsWaiting()) {
    const ByteView rest = ByteView(buffer_).subspan(begin_);
    const Found found = Look(rest);
    if (found == Found::kIncomplete) return std::nullopt;
    if (found != Found::kPacket) {
      if (found == Found::kBad) ++bad_;
      ++begin_;
      continue;
    }
    const std::size_t length = LengthOf(rest);
    Bytes body = *Unstuffed(rest.subspan(kBodyAt, length - 2));
    begin_ += kBodyAt + length;
    return Packet{rest[4], body.front(), Bytes(body.begin() + 1, body.end())};
  }
  return std::nullopt;
}

void PacketDecoder::GiveUp() {
  if (IsWaiting()) ++begin_;
}

}  // namespace ariadne::drivers::dynamixel
