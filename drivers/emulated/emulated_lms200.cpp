#include "drivers/emulated/emulated_lms200.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace ariadne::drivers {
namespace {

constexpr double kLongestPause = 0.014;  // between two bytes of a telegram [s], spec 9.1

}  // namespace

EmulatedLms200::EmulatedLms200(const EmulatedLms200Options& options, SweepSource source)
    : options_(options),
      source_(std::move(source)),
      noise_(NamedStream(1, "emulated lms200/noise")),
      config_(lms200::FactoryConfig(options.old_config ? lms200::kOldConfigSize : lms200::kConfigSize)) {
  CheckOptions(options_, "emulated_lms200.");
  Boot(0.0);
}

void EmulatedLms200::Boot(double time) {
  ready_at_ = time + options_.boot_time;
  ready_ = false;
  measuring_.reset();
  mean_.clear();
  events_.clear();
  decoder_ = lms200::TelegramDecoder(lms200::Sender::kHost);
}

std::string EmulatedLms200::TypeText() const {
  return options_.s14 ? "LMS291;S14;X01.27" : "LMS200;30106x;V02.10";
}

/// The power-on string comes at the rate of power-on.
void EmulatedLms200::BecomeReady() {
  ready_ = true;
  baud_ = power_on_baud_;
  mode_ = lms200::Mode::kOnRequest;
  variant_ = lms200::Variant{180, 50};
  telegrams_ = 0;
  lms200::PowerOn hello{TypeText(), status_};
  Transmit(ready_at_, lms200::EncodeTelegram({lms200::kFromDevice, lms200::EncodeReply(hello)}));
}

void EmulatedLms200::LosePower(double time, double seconds) { Boot(time + seconds); }

void EmulatedLms200::Receive(ByteView bytes, int baud, double time) {
  if (!ready_) return;
  const double began = time - static_cast<double>(bytes.size()) * 10.0 / baud;
  if (options_.strict && began - received_until_ > kLongestPause) {
    while (decoder_.IsWaiting()) {
      decoder_.GiveUp();
      decoder_.Next();
    }
  }
  received_until_ = time;
  Bytes noise;
  if (baud != baud_) {
    for (std::size_t i = 0; i < bytes.size(); ++i)
      noise.push_back(static_cast<std::uint8_t>(noise_() & 0xFF));
    bytes = noise;
  }
  decoder_.Push(bytes);
  while (const std::optional<lms200::Received> received = decoder_.Next()) {
    if (received->kind == lms200::Received::Kind::kBadCrc) Refuse(time);
    if (received->kind != lms200::Received::Kind::kTelegram) continue;
    if (options_.strict && received->telegram.address != 0) continue;
    Execute(received->telegram.payload, time);
  }
}

double EmulatedLms200::NextTime() const {
  double next = ready_ ? std::numeric_limits<double>::infinity() : ready_at_;
  if (!events_.empty()) next = std::min(next, events_.front().time);
  if (measuring_) next = std::min(next, SweepEnd());
  return next;
}

std::vector<Sending> EmulatedLms200::Advance(double time) {
  for (double next = NextTime(); next <= time; next = NextTime()) {
    now_ = std::max(now_, next);
    if (!ready_) {
      BecomeReady();
    } else if (!events_.empty() && events_.front().time <= next) {
      Event event = std::move(events_.front());
      events_.pop_front();
      if (!event.bytes.empty()) Transmit(event.time, std::move(event.bytes));
      if (event.then) event.then();
    } else {
      Measure();
    }
  }
  now_ = std::max(now_, time);
  return std::exchange(sendings_, {});
}

void EmulatedLms200::Transmit(double time, Bytes bytes) {
  Sending sending;
  sending.start = std::max(time, sent_until_);
  sending.byte_time = options_.paced ? 10.0 / baud_ : 0.0;
  sending.baud = baud_;
  sending.bytes = std::move(bytes);
  sent_until_ = sending.start + sending.byte_time * static_cast<double>(sending.bytes.size());
  sendings_.push_back(std::move(sending));
}

void EmulatedLms200::Send(double time, Bytes bytes, std::function<void()> then) {
  const auto after = std::upper_bound(events_.begin(), events_.end(), time,
                                      [](double t, const Event& event) { return t < event.time; });
  events_.insert(after, Event{time, std::move(bytes), std::move(then)});
}

void EmulatedLms200::Refuse(double time) { Send(time + options_.ack_delay, {lms200::kNakByte}); }

/// ACK, the reply, and then what the command changes.
void EmulatedLms200::Acknowledge(double time, const lms200::Reply& reply, double delay,
                                 std::function<void()> then) {
  time += options_.ack_delay;
  Send(time, {lms200::kAckByte});
  Send(time + delay, lms200::EncodeTelegram({lms200::kFromDevice, lms200::EncodeReply(reply)}),
       std::move(then));
}

}  // namespace ariadne::drivers
