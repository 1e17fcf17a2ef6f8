#include <fmt/format.h>

#include <optional>

#include "drivers/hardware/devices/line_telegrams.h"
#include "drivers/hardware/hobby_servo/maestro.h"

namespace ariadne::drivers {
namespace {

using MaestroCode = hobby_servo::Code;

std::string MaestroText(const hobby_servo::Request& request) {
  switch (request.code) {
    case MaestroCode::kSetTarget:
      return fmt::format("channel {}: pulse {} us", request.channel, 0.25 * request.number);
    case MaestroCode::kSetSpeed:
      return fmt::format("channel {}: speed {}", request.channel, request.number);
    case MaestroCode::kSetAcceleration:
      return fmt::format("channel {}: acceleration {}", request.channel, request.number);
    case MaestroCode::kPosition:
      return fmt::format("channel {}: ask for the pulse", request.channel);
    case MaestroCode::kErrors:
      return "ask for the errors";
    case MaestroCode::kDetectBaud:
      return "find the rate";
  }
  return "";
}

/// Answers are two bytes, and what was asked says which.
class MaestroTelegramReader : public TelegramReader {
 public:
  std::vector<LineTelegram> Take(const LineRecord& record) override {
    std::vector<LineTelegram> telegrams;
    if (record.kind == LineRecord::Kind::kWrite) Ask(record, telegrams);
    if (record.kind == LineRecord::Kind::kRead) Answer(record, telegrams);
    return telegrams;
  }

 private:
  void Ask(const LineRecord& record, std::vector<LineTelegram>& telegrams) {
    hobby_servo::RequestDecoder decoder;
    decoder.Push(record.bytes);
    while (const std::optional<hobby_servo::Request> request = decoder.Next()) {
      if (asked_) telegrams.push_back({record.time, false, true, "no answer", {}});
      const bool answered =
          request->code == MaestroCode::kPosition || request->code == MaestroCode::kErrors;
      asked_ = answered ? request : std::nullopt;
      answer_.clear();
      telegrams.push_back({record.time, true, false, MaestroText(*request), {}});
    }
  }

  void Answer(const LineRecord& record, std::vector<LineTelegram>& telegrams) {
    if (!asked_ || record.bytes.empty()) return;
    answer_.insert(answer_.end(), record.bytes.begin(), record.bytes.end());
    if (answer_.size() < 2) return;
    const bool bad = answer_.size() > 2;
    const int number = hobby_servo::NumberOf(answer_);
    const std::string text = bad ? fmt::format("{} bytes too many", answer_.size() - 2)
                             : asked_->code == MaestroCode::kPosition
                                 ? fmt::format("pulse {} us", 0.25 * number)
                                 : fmt::format("errors 0x{:04X}", number);
    telegrams.push_back({record.time, false, bad, text, {}});
    asked_.reset();
  }

  std::optional<hobby_servo::Request> asked_;
  Bytes answer_;
};

}  // namespace

std::unique_ptr<TelegramReader> MakeMaestroReader() { return std::make_unique<MaestroTelegramReader>(); }

}  // namespace ariadne::drivers
