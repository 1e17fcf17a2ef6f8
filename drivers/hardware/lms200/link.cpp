#include "drivers/hardware/lms200/link.h"

#include <algorithm>

namespace ariadne::drivers::lms200 {
namespace {

/// After such a pause the rest of a telegram does not come any more: the device pauses up to 14 ms within
/// one (spec 9.1), and adapters keep bytes back for up to 16 ms.
constexpr double kLongestPause = 0.05;  // [s]

constexpr double kAdapterTime = 0.03;   // what adapters and the system may add, there and back [s]
constexpr double kWaitAfterNak = 0.03;  // spec 9.1 [s]

std::uint8_t CodeOf(const Reply& reply) { return EncodeReply(reply).front(); }

bool Answers(const Reply& reply, Code code) {
  const std::uint8_t wanted = code == Code::kReset ? kResetConfirmed : ReplyTo(code);
  const std::uint8_t given = CodeOf(reply);
  return given == wanted || given == kUnknownCommand;
}

}  // namespace

LinkCounters Link::counters() const {
  LinkCounters counters = counters_;
  counters.garbage += decoder_.garbage();
  return counters;
}

void Link::SetBaud(int baud) {
  line_.SetBaud(baud);
  counters_.garbage += decoder_.garbage();
  decoder_ = TelegramDecoder(Sender::kDevice);
  pieces_.clear();
}

double Link::UsualAck() const {
  if (acks_.empty()) return kLongestAck;
  std::deque<double> sorted = acks_;
  std::sort(sorted.begin(), sorted.end());
  return sorted[sorted.size() / 2];
}

void Link::TakeIn(const Bytes& bytes) {
  last_byte_ = line_.Now();
  while (!pieces_.empty() && pieces_.front().end <= decoder_.position()) pieces_.pop_front();
  const std::uint64_t before = pieces_.empty() ? decoder_.position() : pieces_.back().end;
  pieces_.push_back({before + bytes.size(), last_byte_});
  decoder_.Push(bytes);
}

/// Adapters hand over bytes in pieces, up to a piece late. As a telegram's bytes follow each other on the
/// line, each piece tells by when its last one was sent; the earliest of that is the least late.
double Link::TimeOfEnd(const Received& received) {
  if (received.kind != Received::Kind::kTelegram) return last_byte_;
  const std::uint64_t begin = received.end - received.telegram.payload.size() - kFrameSize;
  double time = last_byte_;
  for (const Piece& piece : pieces_) {
    if (piece.end <= begin) continue;
    const std::uint64_t missing = received.end - std::min(piece.end, received.end);
    time = std::min(time, piece.time + TimeOf(missing));
  }
  return time;
}

/// What is there at once has come while nobody listened; behind it all is new.
std::optional<Link::Item> Link::NextItem(double deadline) {
  for (bool drained = false;;) {
    if (const std::optional<Received> received = decoder_.Next())
      return Item{*received, TimeOfEnd(*received), waited_};
    const bool waiting = decoder_.IsWaiting();
    const double until = waiting ? std::min(deadline, last_byte_ + kLongestPause) : deadline;
    const Bytes bytes = line_.Read(drained ? until : line_.Now());
    if (!bytes.empty()) {
      TakeIn(bytes);
      waited_ = !drained;
    } else if (!drained) {
      drained = true;
    } else if (waiting && line_.Now() >= last_byte_ + kLongestPause) {
      decoder_.GiveUp();
    } else if (line_.Now() >= deadline) {
      return std::nullopt;
    }
  }
}

std::optional<Link::Arrived> Link::ReplyOf(const Item& item) {
  switch (item.received.kind) {
    case Received::Kind::kTelegram:
      break;
    case Received::Kind::kBadCrc:
      ++counters_.bad_checksums;
      return std::nullopt;
    case Received::Kind::kNak:
      ++counters_.naks;
      return std::nullopt;
    case Received::Kind::kAck:
      return std::nullopt;
  }
  ++counters_.telegrams;
  const Bytes& payload = item.received.telegram.payload;
  try {
    Arrived arrived{DecodeReply(payload), item.time, payload.size() + kFrameSize, 0.0, item.waited};
    if (std::holds_alternative<PowerOn>(arrived.reply)) ++counters_.power_ons;
    return arrived;
  } catch (const Error&) {
    ++counters_.bad_contents;
    return std::nullopt;
  }
}

std::optional<Link::Arrived> Link::NextReply(double deadline) {
  while (const std::optional<Item> item = NextItem(deadline)) {
    if (std::optional<Arrived> arrived = ReplyOf(*item)) return arrived;
  }
  return std::nullopt;
}

std::optional<Link::Arrived> Link::Ask(const Command& command, double reply_time, int tries) {
  for (int i = 0; i < tries; ++i) {
    if (i > 0) ++counters_.repeated;
    std::optional<Arrived> arrived = AskOnce(command, reply_time);
    if (!arrived) continue;
    if (CodeOf(arrived->reply) == kUnknownCommand) {
      Fail("the scanner on {} does not know command 0x{:02X}; is it an LMS-200?", line_.name(),
           static_cast<int>(command.code));
    }
    return arrived;
  }
  return std::nullopt;
}

/// The device may first have to end a telegram, of which there are bytes then.
std::optional<Link::Arrived> Link::AskOnce(const Command& command, double reply_time) {
  const Bytes frame = EncodeTelegram({0, EncodeCommand(command)});
  line_.Write(frame);
  const double longest = TimeOf(kMaxPayload + kFrameSize);
  const double asked = line_.Now() + TimeOf(frame.size());
  const double sent = asked + kAdapterTime;
  double deadline = sent + kLongestAck;
  bool busy = false;
  bool acknowledged = false;
  while (true) {
    const std::optional<Item> item = NextItem(deadline);
    if (!item) {
      if (busy || acknowledged || last_byte_ < sent - kAdapterTime) return std::nullopt;
      busy = true;
      deadline = sent + kLongestAck + longest;
      continue;
    }
    if (!acknowledged && item->received.kind == Received::Kind::kNak) {
      ++counters_.naks;
      DiscardUntil(line_, line_.Now() + kWaitAfterNak);
      return std::nullopt;
    }
    if (!acknowledged && item->received.kind == Received::Kind::kAck) {
      acknowledged = true;
      acks_.push_back(item->time - asked);
      if (acks_.size() > 7) acks_.pop_front();
      deadline = item->time + kAdapterTime + reply_time + 2.0 * longest;
    }
    std::optional<Arrived> arrived = ReplyOf(*item);
    if (!arrived || !Answers(arrived->reply, command.code)) continue;
    arrived->asked = asked;
    return arrived;
  }
}

}  // namespace ariadne::drivers::lms200
