#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>

#include "drivers/hardware/byte_stream.h"
#include "drivers/hardware/lms200/command.h"
#include "drivers/hardware/lms200/reply.h"
#include "drivers/hardware/lms200/telegram_decoder.h"

namespace ariadne::drivers::lms200 {

/// To the device's ACK (spec 9.1) [s].
constexpr double kLongestAck = 0.06;

/// What a link has seen, since it was made.
struct LinkCounters {
  std::uint64_t telegrams = 0;
  std::uint64_t bad_checksums = 0;
  std::uint64_t bad_contents = 0;  // the right checksum around what no device can mean
  std::uint64_t naks = 0;
  std::uint64_t repeated = 0;   // questions
  std::uint64_t power_ons = 0;  // the device has booted
  std::uint64_t garbage = 0;    // bytes
};

/// The conversation with a scanner over a line: who asks waits for ACK and reply, and repeats the question
/// after a NAK or silence (spec 9.1). Errors are those of the line.
class Link {
 public:
  explicit Link(ByteStream& line) : line_(line) {}

  struct Arrived {
    Reply reply;
    double time = 0.0;     // when the last byte was there, or would have been if none had waited [s]
    std::size_t size = 0;  // of the frame [B]
    double asked = 0.0;    // when the request had left, of the reply to one [s]
    bool waited = false;   // it was there before anybody listened, nobody knows for how long
  };

  /// The next reply that arrives by itself until `deadline` [s]; bad ones are counted and passed over.
  std::optional<Arrived> NextReply(double deadline);

  /// Asks up to `tries` times and waits `reply_time` [s] beyond what the line needs. None if there is no
  /// reply. A reply counts without ACK, which may have been lost. Replies to others are dropped meanwhile.
  /// Error if the device does not know the command.
  std::optional<Arrived> Ask(const Command& command, double reply_time, int tries = 3);

  /// Changes the rate of this end and forgets what has arrived.
  void SetBaud(int baud);

  ByteStream& line() { return line_; }
  const ByteStream& line() const { return line_; }
  LinkCounters counters() const;

  /// From a request to its ACK, as a rule: the median of the latest; 60 ms before the first one [s].
  double UsualAck() const;

  /// How long so many bytes take on the line [s].
  double TimeOf(std::size_t bytes) const { return static_cast<double>(bytes) * 10.0 / line_.baud(); }

 private:
  struct Item {
    Received received;
    double time;
    bool waited;
  };
  /// Bytes that were read in one go.
  struct Piece {
    std::uint64_t end;  // in the decoder's stream [B]
    double time;        // [s]
  };

  std::optional<Item> NextItem(double deadline);
  void TakeIn(const Bytes& bytes);
  double TimeOfEnd(const Received& received);
  std::optional<Arrived> ReplyOf(const Item& item);
  std::optional<Arrived> AskOnce(const Command& command, double reply_time);

  ByteStream& line_;
  TelegramDecoder decoder_{Sender::kDevice};
  LinkCounters counters_;
  std::deque<Piece> pieces_;  // that telegrams may still be in
  double last_byte_ = 0.0;    // [s]
  bool waited_ = false;       // what was read last was there before anybody listened
  std::deque<double> acks_;   // how long the latest took [s]
};

}  // namespace ariadne::drivers::lms200
