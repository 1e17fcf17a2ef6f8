#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <optional>

#include "drivers/hardware/devices/line_telegrams.h"
#include "drivers/hardware/roboclaw/packet.h"

namespace ariadne::drivers {
namespace {

using roboclaw::Code;

std::int32_t SignedIn(ByteView data, std::size_t at) {
  return static_cast<std::int32_t>(roboclaw::NumberAt(data, at, 4));
}

std::string RequestText(const roboclaw::Request& request) {
  const ByteView data = request.data;
  switch (request.code) {
    case Code::kSetTimeout:
      return fmt::format("set the timeout to {} s", data[0] * 0.1);
    case Code::kTimeout:
      return "ask for the timeout";
    case Code::kVersion:
      return "ask for the version";
    case Code::kBattery:
      return "ask for the battery";
    case Code::kSpeeds:
      return fmt::format("speeds {} {}", SignedIn(data, 0), SignedIn(data, 4));
    case Code::kSpeedsWithAcceleration:
      return fmt::format("speeds {} {} with acceleration {}", SignedIn(data, 4), SignedIn(data, 8),
                         roboclaw::NumberAt(data, 0, 4));
    case Code::kCurrents:
      return "ask for the currents";
    case Code::kEncoders:
      return "ask for the counts";
    case Code::kMeasuredSpeeds:
      return "ask for the speeds";
    case Code::kStatus:
      return "ask for the status";
    default:
      return fmt::format("command {}", static_cast<int>(request.code));
  }
}

void UnderstandReply(Code code, ByteView data, LineTelegram& telegram) {
  if (code == Code::kEncoders) {
    telegram.value = LineCounts{{SignedIn(data, 0), SignedIn(data, 4)}};
    telegram.text = fmt::format("counts {} {}", SignedIn(data, 0), SignedIn(data, 4));
  } else if (code == Code::kMeasuredSpeeds) {
    telegram.text = fmt::format("speeds {} {}", SignedIn(data, 0), SignedIn(data, 4));
  } else if (code == Code::kBattery) {
    telegram.text = fmt::format("battery {:.1f} V", roboclaw::NumberAt(data, 0, 2) * 0.1);
  } else if (code == Code::kVersion) {
    telegram.text.assign(data.begin(), std::find(data.begin(), data.end(), std::uint8_t{'\n'}));
  } else if (code == Code::kStatus) {
    telegram.text = fmt::format("status 0x{:04X}", roboclaw::NumberAt(data, 0, 2));
  } else {
    telegram.text = fmt::format("answer of {} bytes", data.size());
  }
}

/// Replies have neither beginning nor kind: the request before them says both.
class RoboclawTelegramReader : public TelegramReader {
 public:
  std::vector<LineTelegram> Take(const LineRecord& record) override {
    std::vector<LineTelegram> telegrams;
    if (record.kind == LineRecord::Kind::kWrite) Ask(record, telegrams);
    if (record.kind == LineRecord::Kind::kRead) Answer(record, telegrams);
    return telegrams;
  }

 private:
  void Ask(const LineRecord& record, std::vector<LineTelegram>& telegrams) {
    const bool at_board = !record.bytes.empty() && record.bytes[0] >= 0x80 && record.bytes[0] <= 0x87;
    if (!at_board) return;
    address_ = record.bytes[0];
    roboclaw::RequestDecoder decoder(address_);
    decoder.Push(record.bytes);
    if (pending_) {
      telegrams.push_back({record.time,
                           false,
                           true,
                           reply_.empty() ? "no answer" : "half an answer, or a wrong checksum",
                           {}});
    }
    pending_ = decoder.Next();
    reply_.clear();
    if (pending_) telegrams.push_back({record.time, true, false, RequestText(*pending_), {}});
  }

  void Answer(const LineRecord& record, std::vector<LineTelegram>& telegrams) {
    if (!pending_ || record.bytes.empty()) return;
    reply_.insert(reply_.end(), record.bytes.begin(), record.bytes.end());
    LineTelegram telegram{record.time, false, false, "done", {}};
    try {
      if (roboclaw::IsWrite(pending_->code)) {
        if (reply_ != Bytes{roboclaw::kAcknowledged}) Fail("an answer that is none to a command");
      } else {
        const std::optional<Bytes> data = roboclaw::DecodeReply(address_, pending_->code, reply_);
        if (!data) return;
        UnderstandReply(pending_->code, *data, telegram);
      }
    } catch (const Error& error) {
      telegram.bad = true;
      telegram.text = error.what();
    }
    pending_.reset();
    telegrams.push_back(std::move(telegram));
  }

  std::uint8_t address_ = 0x80;
  std::optional<roboclaw::Request> pending_;
  Bytes reply_;
};

}  // namespace

std::unique_ptr<TelegramReader> MakeRoboclawReader() { return std::make_unique<RoboclawTelegramReader>(); }

}  // namespace ariadne::drivers
