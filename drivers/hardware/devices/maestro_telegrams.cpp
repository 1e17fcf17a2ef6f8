#include <fmt/format.h>

#include <optional>

#include "drivers/hardware/devices/answer_reader.h"
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
class MaestroTelegramReader : public AnswerReader<hobby_servo::Request> {
 protected:
  std::vector<hobby_servo::Request> RequestsIn(ByteView bytes) override {
    hobby_servo::RequestDecoder decoder;
    decoder.Push(bytes);
    std::vector<hobby_servo::Request> requests;
    while (const std::optional<hobby_servo::Request> request = decoder.Next()) requests.push_back(*request);
    return requests;
  }
  bool IsAnswered(const hobby_servo::Request& request) const override {
    return request.code == MaestroCode::kPosition || request.code == MaestroCode::kErrors;
  }
  std::string TextOf(const hobby_servo::Request& request) const override { return MaestroText(request); }

  std::optional<LineTelegram> Understand(const hobby_servo::Request& request,
                                         ByteView answer) const override {
    if (answer.size() < 2) return std::nullopt;
    if (answer.size() > 2) Fail("{} bytes too many", answer.size() - 2);
    const int number = hobby_servo::NumberOf(answer);
    const bool position = request.code == MaestroCode::kPosition;
    return LineTelegram{
        0.0,
        false,
        false,
        position ? fmt::format("pulse {} us", 0.25 * number) : fmt::format("errors 0x{:04X}", number),
        {}};
  }
};

}  // namespace

std::unique_ptr<TelegramReader> MakeMaestroReader() { return std::make_unique<MaestroTelegramReader>(); }

}  // namespace ariadne::drivers
