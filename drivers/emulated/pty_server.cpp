#include "drivers/emulated/pty_server.h"

#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstring>
#include <deque>
#include <limits>
#include <utility>
#include <vector>

#include "slam/base/error.h"
#include "slam/base/random.h"

namespace ariadne::drivers {
namespace {

double MonotonicTime() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// Bytes are handed over in pieces: of a UART's memory, or of a frame of USB, which are fewer wake-ups.
constexpr std::size_t kFifo = 16;     // [B]
constexpr double kFrameTime = 0.001;  // [s]

constexpr std::array<std::pair<speed_t, int>, 8> kSpeeds{{{B9600, 9600},
                                                          {B19200, 19200},
                                                          {B38400, 38400},
                                                          {B57600, 57600},
                                                          {B115200, 115200},
                                                          {B460800, 460800},
                                                          {B500000, 500000},
                                                          {B1000000, 1000000}}};

}  // namespace

/// Bytes on their way to the host, each due at its time.
struct PtyServer::Outgoing {
  std::deque<Sending> sendings;
  std::size_t sent = 0;  // of the first one [B]
  RandomStream noise = NamedStream(1, "pty server/noise");
};

PtyServer::PtyServer(EmulatedDevice& device) : PtyServer(device, MonotonicTime()) {}

PtyServer::PtyServer(EmulatedDevice& device, const PtyServer& other) : PtyServer(device, other.start_) {}

PtyServer::PtyServer(EmulatedDevice& device, double start)
    : device_(device), start_(start), outgoing_(std::make_unique<Outgoing>()) {
  std::array<char, 256> name{};
  if (openpty(&device_end_, &host_end_, name.data(), nullptr, nullptr) != 0) {
    Fail("cannot make a pseudo-terminal: {}", std::strerror(errno));
  }
  path_ = name.data();
  fcntl(device_end_, F_SETFL, fcntl(device_end_, F_GETFL) | O_NONBLOCK);  // a host may not read
  termios settings{};
  tcgetattr(host_end_, &settings);
  cfmakeraw(&settings);  // until a program sets it, nothing is echoed
  cfsetspeed(&settings, B9600);
  tcsetattr(host_end_, TCSANOW, &settings);
}

PtyServer::~PtyServer() {
  close(device_end_);
  close(host_end_);
}

double PtyServer::Now() const { return MonotonicTime() - start_; }

int PtyServer::HostBaud() const {
  termios settings{};
  tcgetattr(device_end_, &settings);
  const speed_t speed = cfgetospeed(&settings);
  const auto known = std::find_if(kSpeeds.begin(), kSpeeds.end(),
                                  [speed](const auto& pair) { return pair.first == speed; });
  return known == kSpeeds.end() ? 0 : known->second;
}

void PtyServer::TakeSendings(double time) {
  const auto take = [this](double until) {
    for (Sending& sending : device_.Advance(until)) outgoing_->sendings.push_back(std::move(sending));
  };
  while (const std::optional<LineFault> fault = faults_.TakePowerLoss(time)) {
    take(time);
    device_.LosePower(time, fault->duration);
  }
  take(time);
}

/// When the next byte is due; infinity where none is on its way.
double PtyServer::NextSend() const {
  if (outgoing_->sendings.empty()) return std::numeric_limits<double>::infinity();
  const Sending& first = outgoing_->sendings.front();
  const std::size_t left = first.bytes.size() - outgoing_->sent;
  const auto in_a_frame =
      first.byte_time > 0.0 ? static_cast<std::size_t>(kFrameTime / first.byte_time) : left;
  const std::size_t piece = outgoing_->sent + std::min(left, std::max(kFifo, in_a_frame));
  return std::max(held_until_, first.start + static_cast<double>(piece) * first.byte_time);
}

void PtyServer::SendDue() {
  while (NextSend() <= Now()) {
    Sending& first = outgoing_->sendings.front();
    std::size_t due = first.bytes.size();
    if (first.byte_time > 0.0) {
      due = std::min(due, static_cast<std::size_t>(std::max(0.0, (Now() - first.start) / first.byte_time)));
    }
    due = std::max(due, outgoing_->sent);
    const Bytes piece = PieceOf(first, outgoing_->sent, due);
    // A program that does not read loses bytes, as with a serial port.
    if (write(device_end_, piece.data(), piece.size()) < 0 && errno != EAGAIN) {
      Fail("cannot write to {}: {}", path_, std::strerror(errno));
    }
    outgoing_->sent = due;
    if (outgoing_->sent < first.bytes.size()) break;
    outgoing_->sendings.pop_front();
    outgoing_->sent = 0;
  }
}

/// What the line makes of bytes `from` to `to`.
Bytes PtyServer::PieceOf(const Sending& sending, std::size_t from, std::size_t to) {
  const bool other_rate = sending.baud != HostBaud();
  const double now = Now();
  Bytes piece;
  for (std::size_t i = from; i < to; ++i) {
    const auto noise = other_rate ? static_cast<std::uint8_t>(outgoing_->noise() & 0xFF) : std::uint8_t{0};
    const LineFaults::Passed passed = faults_.Pass(other_rate ? noise : sending.bytes[i], now, false);
    if (passed.delay > 0.0) held_until_ = now + passed.delay;
    piece.insert(piece.end(), static_cast<std::size_t>(passed.copies), passed.byte);
  }
  return piece;
}

void PtyServer::Receive(ByteView bytes, double time) {
  Bytes arrived;
  for (const std::uint8_t byte : bytes) {
    const LineFaults::Passed passed = faults_.Pass(byte, time, true);
    arrived.insert(arrived.end(), static_cast<std::size_t>(passed.copies), passed.byte);
  }
  if (!arrived.empty()) device_.Receive(arrived, HostBaud(), time);
}

void PtyServer::Serve(const std::stop_token& stop, double poll) {
  PtyServer* const self = this;
  ServeAll(
      {&self, 1}, [&stop](double) { return !stop.stop_requested(); }, poll);
}

void PtyServer::ServeAll(std::span<PtyServer* const> servers,
                         const std::function<bool(double now)>& goes_on, double poll_time) {
  std::array<std::uint8_t, 4096> buffer;
  std::vector<pollfd> inputs;
  for (const PtyServer* server : servers) inputs.push_back({server->device_end_, POLLIN, 0});
  const auto live_until = [&servers](double time) {
    for (PtyServer* server : servers) server->TakeSendings(time);
  };
  for (double now = servers.front()->Now(); goes_on(now); now = servers.front()->Now()) {
    live_until(now);
    double next = now + poll_time;
    for (PtyServer* server : servers) {
      server->SendDue();
      next = std::min({next, server->device_.NextTime(), server->NextSend()});
    }
    const double wait = std::max(0.0, next - servers.front()->Now());
    const timespec duration{static_cast<time_t>(wait), static_cast<long>(std::fmod(wait, 1.0) * 1e9)};
    if (ppoll(inputs.data(), inputs.size(), &duration, nullptr) <= 0) continue;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      if ((inputs[i].revents & POLLIN) == 0) continue;
      const ssize_t count = read(inputs[i].fd, buffer.data(), buffer.size());
      if (count <= 0) continue;
      now = servers.front()->Now();
      live_until(now);
      servers[i]->Receive(ByteView(buffer.data(), static_cast<std::size_t>(count)), now);
    }
  }
}

}  // namespace ariadne::drivers
