#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "drivers/hardware/devices/line_telegrams.h"
#include "drivers/hardware/lms200/command.h"
#include "drivers/hardware/lms200/reply.h"
#include "drivers/hardware/lms200/telegram_decoder.h"

namespace ariadne::drivers {
namespace {

using lms200::Received;
using lms200::Sender;

std::string CommandText(const lms200::Command& command) {
  switch (command.code) {
    case lms200::Code::kReset:
      return "reset";
    case lms200::Code::kMode:
      return fmt::format("set mode 0x{:02X}", static_cast<int>(command.mode));
    case lms200::Code::kScan:
      return "ask for a sweep";
    case lms200::Code::kStatus:
      return "ask for the status";
    case lms200::Code::kErrors:
      return "ask for the errors";
    case lms200::Code::kType:
      return "ask for the type";
    case lms200::Code::kVariant:
      return fmt::format("set {} deg by {} deg", command.angle, command.resolution / 100.0);
    case lms200::Code::kReadConfig:
      return "ask for the configuration";
    case lms200::Code::kWriteConfig:
      return "write the configuration";
    default:
      return fmt::format("command 0x{:02X}", static_cast<int>(command.code));
  }
}

/// What a reply says in a line; measured values need the mode of measuring, and are not among them.
struct ReplyText {
  std::string operator()(const lms200::PowerOn& r) const {
    return fmt::format("has been switched on: {}", r.type);
  }
  std::string operator()(const lms200::Notice& r) const {
    return r.code == lms200::kUnknownCommand ? "does not know the command" : "restarts";
  }
  std::string operator()(const lms200::ModeReply& r) const {
    return r.answer == lms200::ModeAnswer::kOk ? "mode is set" : "mode is refused";
  }
  std::string operator()(const lms200::ErrorReply& r) const {
    return fmt::format("{} errors in its memory", r.entries.size());
  }
  std::string operator()(const lms200::TypeReply& r) const { return fmt::format("type {}", r.type); }
  std::string operator()(const lms200::VariantReply& r) const {
    return fmt::format("{}: {} deg by {} deg", r.ok ? "set" : "refused", r.angle, r.resolution / 100.0);
  }
  std::string operator()(const lms200::PermanentBaudReply& r) const {
    return r.ok ? "rate is kept" : "rate is not kept";
  }
  std::string operator()(const lms200::ConfigReply& r) const {
    return fmt::format("configuration of {} bytes", r.config.bytes.size());
  }
  std::string operator()(const lms200::WrittenReply& r) const {
    return r.ok ? "configuration is written" : "configuration is refused";
  }
  std::string operator()(const lms200::StatusReply& r) const {
    return fmt::format("status: software {}, {} baud, {} deg by {} deg, error {}", r.software, r.baud,
                       r.variant.field_of_view, r.variant.resolution / 100.0, r.error);
  }
  std::string operator()(const lms200::MeasuredValues& r) const {
    return fmt::format("{} values", r.words.size());
  }
};

/// Severe enough to be no ordinary answer.
bool ReportsAnError(std::uint8_t status) { return lms200::DeviceStatusOf(status).severity >= 3; }

class Lms200TelegramReader : public TelegramReader {
 public:
  std::vector<LineTelegram> Take(const LineRecord& record) override {
    std::vector<LineTelegram> telegrams;
    if (record.baud > 0) baud_ = record.baud;
    if (record.kind == LineRecord::Kind::kBaud) {
      from_device_ = lms200::TelegramDecoder(Sender::kDevice);
    } else if (record.kind == LineRecord::Kind::kWrite) {
      Find(to_device_, record, true, telegrams);
    } else if (record.kind == LineRecord::Kind::kRead) {
      Find(from_device_, record, false, telegrams);
    }
    return telegrams;
  }

 private:
  void Find(lms200::TelegramDecoder& decoder, const LineRecord& record, bool to_device,
            std::vector<LineTelegram>& telegrams) {
    decoder.Push(record.bytes);
    while (const std::optional<Received> received = decoder.Next()) {
      if (received->kind == Received::Kind::kAck) continue;
      LineTelegram telegram{record.time, to_device, false, {}, {}};
      if (received->kind == Received::Kind::kTelegram) {
        Understand(received->telegram, telegram);
      } else {
        telegram.bad = true;
        telegram.text = received->kind == Received::Kind::kNak ? "NAK" : "a wrong checksum";
      }
      telegrams.push_back(std::move(telegram));
    }
  }

  void Understand(const lms200::Telegram& received, LineTelegram& telegram) {
    try {
      if (telegram.to_device) {
        telegram.text = CommandText(lms200::DecodeCommand(received.payload));
        return;
      }
      const lms200::Reply reply = lms200::DecodeReply(received.payload);
      telegram.text = std::visit(ReplyText(), reply);
      telegram.bad = ReportsAnError(received.payload.back());
      if (telegram.bad) telegram.text += ", and reports an error";
      Follow(reply);
      if (const auto* values = std::get_if<lms200::MeasuredValues>(&reply))
        telegram.value = SweepIn(*values, received.payload.size());
    } catch (const Error& error) {
      telegram.bad = true;
      telegram.text = error.what();
    }
  }

  /// What the device says about itself decides how later values are read.
  void Follow(const lms200::Reply& reply) {
    if (const auto* config = std::get_if<lms200::ConfigReply>(&reply))
      mode_ = lms200::MeasuringModeOf(config->config);
    if (const auto* written = std::get_if<lms200::WrittenReply>(&reply); written && written->ok)
      mode_ = lms200::MeasuringModeOf(written->config);
    if (const auto* status = std::get_if<lms200::StatusReply>(&reply)) {
      mode_ = status->measuring_mode;
      variant_ = status->variant;
    }
    if (const auto* variant = std::get_if<lms200::VariantReply>(&reply); variant && variant->ok)
      variant_ = {variant->angle, variant->resolution};
  }

  LineSweep SweepIn(const lms200::MeasuredValues& values, std::size_t payload) const {
    constexpr double kDegree = std::numbers::pi / 180.0;
    LineSweep sweep;
    sweep.line_time = static_cast<double>(payload + lms200::kFrameSize) * 10.0 / baud_;
    const double step = values.partial ? 1.0 : variant_.resolution / 100.0;
    const double first = 90.0 - 0.5 * variant_.field_of_view + 0.25 * values.offset +
                         (values.first > 0 ? (values.first - 1) * step : 0.0);
    sweep.first_angle = first * kDegree;
    sweep.angle_step = step * kDegree;
    for (const std::uint16_t word : values.words) {
      const lms200::Echo echo = lms200::EchoOf(word, mode_);
      const bool distance =
          echo.error == lms200::ValueError::kNone && mode_ != lms200::MeasuringMode::kReflectivity;
      sweep.ranges.push_back(distance ? static_cast<float>(echo.number * lms200::Metres(values.unit))
                                      : std::numeric_limits<float>::quiet_NaN());
    }
    return sweep;
  }

  lms200::TelegramDecoder to_device_{Sender::kHost};
  lms200::TelegramDecoder from_device_{Sender::kDevice};
  lms200::MeasuringMode mode_ = lms200::MeasuringMode::k8mFieldsAbDazzle;  // as from the factory
  lms200::Variant variant_;
  int baud_ = 9600;
};

}  // namespace

std::unique_ptr<TelegramReader> MakeLms200Reader() { return std::make_unique<Lms200TelegramReader>(); }

}  // namespace ariadne::drivers
