#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <optional>

#include "drivers/hardware/devices/answer_reader.h"
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

class RoboclawTelegramReader : public AnswerReader<roboclaw::Request> {
 protected:
  std::vector<roboclaw::Request> RequestsIn(ByteView bytes) override {
    const bool at_board = !bytes.empty() && bytes[0] >= 0x80 && bytes[0] <= 0x87;
    if (!at_board) return {};
    address_ = bytes[0];
    roboclaw::RequestDecoder decoder(address_);
    decoder.Push(bytes);
    const std::optional<roboclaw::Request> request = decoder.Next();
    if (!request) return {};
    return {*request};
  }
  bool IsAnswered(const roboclaw::Request&) const override { return true; }
  std::string TextOf(const roboclaw::Request& request) const override { return RequestText(request); }

  std::optional<LineTelegram> Understand(const roboclaw::Request& request, ByteView answer) const override {
    LineTelegram telegram{0.0, false, false, "done", {}};
    if (roboclaw::IsWrite(request.code)) {
      if (answer.size() != 1 || answer[0] != roboclaw::kAcknowledged)
        Fail("an answer that is none to a command");
      return telegram;
    }
    const std::optional<Bytes> data = roboclaw::DecodeReply(address_, request.code, answer);
    if (!data) return std::nullopt;
    UnderstandReply(request.code, *data, telegram);
    return telegram;
  }

 private:
  std::uint8_t address_ = 0x80;
};

}  // namespace

std::unique_ptr<TelegramReader> MakeRoboclawReader() { return std::make_unique<RoboclawTelegramReader>(); }

}  // namespace ariadne::drivers
