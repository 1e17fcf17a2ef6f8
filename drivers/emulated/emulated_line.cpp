#include "drivers/emulated/emulated_line.h"

#include <algorithm>

namespace ariadne::drivers {
namespace {

bool LastsLong(const LineFault& fault) { return fault.kind == LineFault::Kind::kDead; }

}  // namespace

EmulatedLine::EmulatedLine(EmulatedDevice& device, const EmulatedLineOptions& options)
    : device_(device),
      options_(options),
      noise_(NamedStream(options.seed, "emulated line/noise")),
      time_(options.time ? options.time : std::make_shared<VirtualTime>()) {}

void EmulatedLine::Inject(const LineFault& fault) { faults_.push_back(fault); }

double EmulatedLine::NextTime() const {
  double next = device_.NextTime();
  if (!arrivals_.empty()) next = std::min(next, arrivals_.front().time);
  if (!requests_.empty()) next = std::min(next, requests_.front().time);
  for (const LineFault& fault : faults_) {
    if (fault.kind == LineFault::Kind::kPowerLoss) next = std::min(next, fault.time);
  }
  return next;
}

/// All that happens until `time`, in its order.
void EmulatedLine::GoTo(double time) {
  for (auto fault = faults_.begin(); fault != faults_.end();) {
    if (fault->kind == LineFault::Kind::kPowerLoss && fault->time <= time) {
      Collect(fault->time);
      device_.LosePower(fault->time, fault->duration);
      fault = faults_.erase(fault);
    } else {
      ++fault;
    }
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
  if (IsDead(time)) return;
  int copies = 1;
  for (const LineFault& fault : FaultsOfByte(time, false)) {
    if (fault.kind == LineFault::Kind::kDrop) copies = 0;
    if (fault.kind == LineFault::Kind::kDuplicate) copies = 2;
    if (fault.kind == LineFault::Kind::kFlip) byte ^= static_cast<std::uint8_t>(1U << fault.bit);
    if (fault.kind == LineFault::Kind::kDelay) held_until_ = time + fault.duration;
  }
  last_arrival_ = std::max({last_arrival_, time, held_until_});
  for (int i = 0; i < copies; ++i) arrivals_.push_back({last_arrival_, byte});
}

bool EmulatedLine::IsDead(double time) const {
  return std::any_of(faults_.begin(), faults_.end(), [time](const LineFault& fault) {
    return LastsLong(fault) && time >= fault.time && time < fault.time + fault.duration;
  });
}

/// The faults that this byte suffers; each is used up by its last byte.
std::vector<LineFault> EmulatedLine::FaultsOfByte(double time, bool to_device) {
  std::vector<LineFault> hits;
  if (faults_.empty()) return hits;
  for (LineFault& fault : faults_) {
    const bool other = LastsLong(fault) || fault.kind == LineFault::Kind::kPowerLoss;
    if (other || fault.to_device != to_device || fault.time > time) continue;
    hits.push_back(fault);
    --fault.count;
    if (fault.kind == LineFault::Kind::kDelay) fault.count = 0;
  }
  std::erase_if(faults_, [time](const LineFault& fault) {
    return fault.count <= 0 || (LastsLong(fault) && fault.time + fault.duration <= time);
  });
  return hits;
}

Bytes EmulatedLine::TakeArrived() {
  Bytes bytes;
  while (!arrivals_.empty() && arrivals_.front().time <= time_->now) {
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
  for (std::uint8_t byte : bytes) {
    at += byte_time;
    if (IsDead(at)) continue;
    int copies = 1;
    for (const LineFault& fault : FaultsOfByte(at, true)) {
      if (fault.kind == LineFault::Kind::kDrop) copies = 0;
      if (fault.kind == LineFault::Kind::kDuplicate) copies = 2;
      if (fault.kind == LineFault::Kind::kFlip) byte ^= static_cast<std::uint8_t>(1U << fault.bit);
      if (fault.kind == LineFault::Kind::kDelay) at += fault.duration;
    }
    request.bytes.insert(request.bytes.end(), static_cast<std::size_t>(copies), byte);
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
