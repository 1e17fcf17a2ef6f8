#include "drivers/emulated/emulated_line.h"

#include <algorithm>

namespace ariadne::drivers {

EmulatedLine::EmulatedLine(EmulatedDevice& device, const EmulatedLineOptions& options)
    : device_(device),
      options_(options),
      noise_(NamedStream(options.seed, "emulated line/noise")),
      time_(options.time ? options.time : std::make_shared<VirtualTime>()) {}

double EmulatedLine::NextTime() const {
  double next = device_.NextTime();
  if (!arrivals_.empty()) next = std::min(next, arrivals_.front().time);
  if (!requests_.empty()) next = std::min(next, requests_.front().time);
  return std::min(next, faults_.NextPowerLoss());
}

/// All that happens until `time`, in its order.
void EmulatedLine::GoTo(double time) {
  while (const std::optional<LineFault> fault = faults_.TakePowerLoss(time)) {
    Collect(fault->time);
    device_.LosePower(fault->time, fault->duration);
  }
  while (!requests_.empty() && requests_.front().time <= time) {
    const Request request = std::move(requests_.front());
    requests_.pop_front();
    Collect(request.time);
    device_.Receive(request.bytes, request.baud, request.time);
  }
  Collect(std::max(told_, time));
  told_ = std::max(told_, time);
}

/// The host waits to a time.
void EmulatedLine::WaitTo(double time) {
  GoTo(time);
  time_->now = std::max(time_->now, time);
}

/// Takes what the device sends until `time` and does to it what the line does.
void EmulatedLine::Collect(double time) {
  for (const Sending& sending : device_.Advance(time)) {
    double at = sending.start;
    for (std::uint8_t byte : sending.bytes) {
      at += sending.byte_time;
      if (sending.baud != baud_) byte = static_cast<std::uint8_t>(noise_() & 0xFF);
      Arrive(at, byte);
    }
  }
}

void EmulatedLine::Arrive(double time, std::uint8_t byte) {
  const LineFaults::Passed passed = faults_.Pass(byte, time, false);
  if (passed.delay > 0.0) held_until_ = time + passed.delay;
  if (passed.copies > 0) last_arrival_ = std::max({last_arrival_, time, held_until_});
  for (int i = 0; i < passed.copies; ++i) {
    if (arrivals_.size() < options_.buffer) {
      arrivals_.push_back({last_arrival_, passed.byte});
    } else {
      ++overrun_;
    }
  }
}

Bytes EmulatedLine::TakeArrived() {
  Bytes bytes;
  while (!arrivals_.empty() && arrivals_.front().time <= time_->now && bytes.size() < options_.read_size) {
    bytes.push_back(arrivals_.front().byte);
    arrivals_.pop_front();
  }
  return bytes;
}

Bytes EmulatedLine::Read(double deadline) {
  const auto has_arrived = [this] { return !arrivals_.empty() && arrivals_.front().time <= time_->now; };
  deadline = std::max(deadline, time_->now);
  GoTo(time_->now);
  while (!has_arrived() && time_->now < deadline)
    WaitTo(std::min(deadline, std::max(time_->now, NextTime())));
  if (has_arrived()) WaitTo(std::min(deadline, time_->now + options_.chunk_time));
  return TakeArrived();
}

void EmulatedLine::Write(ByteView bytes) {
  const double byte_time = 10.0 / baud_;
  double at = std::max(time_->now, sent_until_);
  Request request{at, baud_, {}};
  for (const std::uint8_t byte : bytes) {
    at += byte_time;
    const LineFaults::Passed passed = faults_.Pass(byte, at, true);
    at += passed.delay;
    request.bytes.insert(request.bytes.end(), static_cast<std::size_t>(passed.copies), passed.byte);
  }
  request.time = at;
  sent_until_ = at;
  if (!request.bytes.empty()) requests_.push_back(std::move(request));
}

void EmulatedLine::SetBaud(int baud) {
  WaitTo(std::max(time_->now, sent_until_));
  arrivals_.clear();
  baud_ = baud;
}

}  // namespace ariadne::drivers
