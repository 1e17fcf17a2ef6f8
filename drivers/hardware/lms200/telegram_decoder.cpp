#include "drivers/hardware/lms200/telegram_decoder.h"

#include <algorithm>

namespace ariadne::drivers::lms200 {

void TelegramDecoder::Push(ByteView bytes) {
  Compact();
  buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
}

/// Whether `rest` begins with a telegram; each byte is judged as soon as it is there.
TelegramDecoder::Beginning TelegramDecoder::Look(ByteView rest) const {
  const bool device = sender_ == Sender::kDevice;
  const std::size_t shortest = device ? 2 : 1;  // a reply has its status byte
  if (rest[0] != kStxByte) return {Found::kNothing};
  if (rest.size() > 1 && ((rest[1] & kFromDevice) != 0) != device) return {Found::kNothing};
  if (rest.size() < 4) return {Found::kIncomplete};
  const std::size_t length = rest[2] | static_cast<std::size_t>(rest[3]) << 8;
  if (length < shortest || length > kMaxPayload) return {Found::kNothing};
  if (device && rest.size() > 4 && (rest[4] & kFromDevice) == 0) return {Found::kNothing};
  const std::size_t size = length + kFrameSize;
  if (rest.size() < size) return {Found::kIncomplete, size};
  const auto crc = static_cast<std::uint16_t>(rest[size - 2] | rest[size - 1] << 8);
  return {Crc(rest.first(size - 2)) == crc ? Found::kTelegram : Found::kBadCrc, size};
}

std::optional<Received> TelegramDecoder::Next() {
  while (IsWaiting()) {
    const Beginning beginning = Look(ByteView(buffer_).subspan(begin_));
    switch (beginning.found) {
      case Found::kIncomplete:
        return std::nullopt;
      case Found::kTelegram:
        return Take(Received::Kind::kTelegram, beginning.size);
      case Found::kBadCrc:
        acks_count_from_ = std::max(acks_count_from_, position() + beginning.size);
        ++garbage_;
        return Take(Received::Kind::kBadCrc, 1);
      case Found::kNothing:
        if (std::optional<Received> received = TakeByte()) return received;
    }
  }
  return std::nullopt;
}

std::optional<Received> TelegramDecoder::TakeByte() {
  const std::uint8_t byte = buffer_[begin_];
  const bool counts = position() >= acks_count_from_;
  if (counts && byte == kAckByte) return Take(Received::Kind::kAck, 1);
  if (counts && byte == kNakByte) return Take(Received::Kind::kNak, 1);
  ++garbage_;
  ++begin_;
  return std::nullopt;
}

Received TelegramDecoder::Take(Received::Kind kind, std::size_t size) {
  Received received;
  received.kind = kind;
  if (kind == Received::Kind::kTelegram) {
    const auto payload = buffer_.begin() + static_cast<std::ptrdiff_t>(begin_ + 4);
    received.telegram.address = buffer_[begin_ + 1];
    received.telegram.payload.assign(payload, payload + static_cast<std::ptrdiff_t>(size - kFrameSize));
  }
  begin_ += size;
  received.end = position();
  return received;
}

void TelegramDecoder::GiveUp() {
  if (!IsWaiting()) return;
  ++begin_;
  ++garbage_;
}

void TelegramDecoder::Compact() {
  buffer_.erase(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(begin_));
  dropped_ += begin_;
  begin_ = 0;
}

}  // namespace ariadne::drivers::lms200
