#pragma once

#include <cstdint>
#include <optional>

#include "drivers/hardware/lms200/telegram.h"

namespace ariadne::drivers::lms200 {

enum class Sender { kHost, kDevice };

/// What a decoder found in the stream.
struct Received {
  enum class Kind { kAck, kNak, kTelegram, kBadCrc };

  Kind kind = Kind::kAck;
  Telegram telegram;      // of kTelegram; empty otherwise
  std::uint64_t end = 0;  // bytes of the stream up to and with its last one

  bool operator==(const Received&) const = default;
};

/// Finds telegrams in a stream of bytes, whatever stands between them. What it finds depends on the bytes
/// alone and not on how they were cut into pieces. Where something begins like a telegram and its checksum
/// is wrong, the search goes on at its second byte, so that one wrong length costs no other telegram; but
/// an ACK or NAK within it counts as part of it.
class TelegramDecoder {
 public:
  /// `sender` is whose telegrams are looked for: the address and the first byte of the payload tell.
  explicit TelegramDecoder(Sender sender) : sender_(sender) {}

  void Push(ByteView bytes);

  /// The next thing in the stream, none until more bytes come.
  std::optional<Received> Next();

  /// Takes what has begun like a telegram for garbage, because the line has been quiet for longer than the
  /// device pauses within one; Next() may then find what it hid.
  void GiveUp();

  bool IsWaiting() const { return begin_ < buffer_.size(); }    // for the rest of a telegram
  std::uint64_t garbage() const { return garbage_; }            // bytes that belonged to nothing
  std::uint64_t position() const { return dropped_ + begin_; }  // of the search in the stream [B]

 private:
  enum class Found { kNothing, kIncomplete, kBadCrc, kTelegram };
  struct Beginning {
    Found found = Found::kNothing;
    std::size_t size = 0;  // of the whole telegram, once it is known [B]
  };

  Beginning Look(ByteView rest) const;
  std::optional<Received> TakeByte();
  Received Take(Received::Kind kind, std::size_t size);
  void Compact();

  Sender sender_;
  Bytes buffer_;
  std::size_t begin_ = 0;      // of the search within the buffer
  std::uint64_t dropped_ = 0;  // bytes that have left the buffer
  std::uint64_t garbage_ = 0;
  std::uint64_t acks_count_from_ = 0;  // position behind the last broken telegram
};

}  // namespace ariadne::drivers::lms200
