#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "drivers/hardware/devices/line_telegrams.h"
#include "drivers/hardware/dynamixel/packet.h"
#include "drivers/hardware/hobby_servo/maestro.h"
#include "drivers/hardware/lms200/command.h"
#include "drivers/hardware/lms200/reply.h"
#include "drivers/hardware/lms200/telegram_decoder.h"
#include "drivers/hardware/roboclaw/find_reply.h"
#include "drivers/hardware/roboclaw/packet.h"
#include "tests/fuzz/accepts.h"
#include "tests/fuzz/read_by.h"

namespace ariadne::fuzz {
namespace {

using drivers::Bytes;
using drivers::lms200::TelegramDecoder;

constexpr std::uint8_t kBoard = 0x80;  // address of a motor board

/// What a decoder finds in a stream that comes in pieces of at most `piece` bytes, encoded once more and
/// without what lies between.
template <typename Decoder, typename Encode>
std::string FoundIn(std::string_view bytes, std::size_t piece, Decoder decoder, const Encode& encode) {
  std::string found;
  for (; !bytes.empty(); bytes.remove_prefix(std::min(piece, bytes.size()))) {
    decoder.Push(ViewOf(bytes.substr(0, piece)));
    while (const auto next = decoder.Next()) {
      const Bytes encoded = encode(*next);
      found.append(encoded.begin(), encoded.end());
    }
  }
  return found;
}

/// Whether there is something, the same however the stream is cut, and the same again in what was found.
template <typename Decoder, typename Encode>
bool AcceptsStream(std::string_view bytes, const Decoder& decoder, const Encode& encode) {
  const auto read = [&](std::istream& in, const std::string&) {
    const std::string all = AllOf(in);
    std::string found = FoundIn(all, all.size() + 1, decoder, encode);
    for (const std::size_t piece : {1U, 5U, 100U}) {
      if (FoundIn(all, piece, decoder, encode) != found)
        throw std::logic_error("pieces are read differently");
    }
    if (found.empty()) Fail("there is nothing");
    return found;
  };
  return Accepts(bytes, read, [](std::ostream& out, const std::string& found) { out << found; });
}

Bytes FrameOf(const drivers::lms200::Received& received) {
  if (received.kind != drivers::lms200::Received::Kind::kTelegram) return {};
  return drivers::lms200::EncodeTelegram(received.telegram);
}

/// Pieces of a line's record, each behind a byte that says who sent it, and how many bytes it has.
std::vector<drivers::LineRecord> LineRecordsIn(std::string_view bytes) {
  std::vector<drivers::LineRecord> records;
  while (!bytes.empty()) {
    const auto head = static_cast<std::uint8_t>(bytes[0]);
    bytes.remove_prefix(1);
    const std::size_t size = std::min<std::size_t>(head >> 1, bytes.size());
    drivers::LineRecord record;
    record.kind = (head & 1) != 0 ? drivers::LineRecord::Kind::kWrite : drivers::LineRecord::Kind::kRead;
    record.bytes = Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
    record.baud = 9600;
    records.push_back(std::move(record));
    bytes.remove_prefix(size);
  }
  return records;
}

}  // namespace

/// What a scanner sends.
bool AcceptsLms200Stream(std::string_view bytes) {
  return AcceptsStream(bytes, TelegramDecoder(drivers::lms200::Sender::kDevice), FrameOf);
}

/// What it is sent.
bool AcceptsLms200Requests(std::string_view bytes) {
  return AcceptsStream(bytes, TelegramDecoder(drivers::lms200::Sender::kHost), FrameOf);
}

/// What a telegram of either side carries, which no checksum guards here.
bool AcceptsLms200Payload(std::string_view bytes) {
  const auto read = [](std::istream& in, const std::string&) {
    const std::string all = AllOf(in);
    if (!all.empty() && (static_cast<std::uint8_t>(all[0]) & drivers::lms200::kFromDevice) == 0)
      return drivers::lms200::EncodeCommand(drivers::lms200::DecodeCommand(ViewOf(all)));
    return drivers::lms200::EncodeReply(drivers::lms200::DecodeReply(ViewOf(all)));
  };
  return Accepts(bytes, read, [](std::ostream& out, const Bytes& payload) {
    out << std::string(payload.begin(), payload.end());
  });
}

/// The packets on a servo's bus.
bool AcceptsDynamixel(std::string_view bytes) {
  return AcceptsStream(bytes, drivers::dynamixel::PacketDecoder(), drivers::dynamixel::EncodePacket);
}

/// Requests to a motor board.
bool AcceptsRoboclaw(std::string_view bytes) {
  using drivers::roboclaw::Request;
  return AcceptsStream(bytes, drivers::roboclaw::RequestDecoder(kBoard), [](const Request& request) {
    return drivers::roboclaw::EncodeRequest(kBoard, request.code, request.data);
  });
}

/// A motor board's reply to a question for its counts, behind late ones to other questions.
bool AcceptsRoboclawReply(std::string_view bytes) {
  using drivers::roboclaw::Code;
  constexpr std::array kLate{Code::kTimeout, Code::kSpeedsWithAcceleration, Code::kMeasuredSpeeds};
  for (const Code code : {Code::kVersion, Code::kTimeout, Code::kSetTimeout})
    drivers::roboclaw::FindReply(kBoard, code, ViewOf(bytes), kLate);
  const auto found = drivers::roboclaw::FindReply(kBoard, Code::kEncoders, ViewOf(bytes), kLate);
  if (!found.data) return false;
  const Bytes reply = drivers::roboclaw::EncodeReply(kBoard, Code::kEncoders, *found.data);
  const auto again = drivers::roboclaw::FindReply(kBoard, Code::kEncoders, reply, {});
  if (again.data != found.data) throw std::logic_error("the reply that was found is not read");
  return true;
}

/// Requests to a servo controller.
bool AcceptsHobbyServo(std::string_view bytes) {
  return AcceptsStream(bytes, drivers::hobby_servo::RequestDecoder(), drivers::hobby_servo::EncodeRequest);
}

/// What crossed a line, in text; each device's reader must bear what another one said.
bool AcceptsTelegrams(std::string_view bytes) {
  drivers::DeviceGuess guess;
  std::size_t telegrams = 0;
  for (const drivers::LineRecord& record : LineRecordsIn(bytes)) guess.Take(record);
  const auto reader = drivers::MakeTelegramReader(guess.Best().kind);
  for (const drivers::LineRecord& record : LineRecordsIn(bytes)) telegrams += reader->Take(record).size();
  return telegrams > 0;
}

}  // namespace ariadne::fuzz
