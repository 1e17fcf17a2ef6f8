#include "drivers/emulated/pty_server.h"

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

PtyServer::PtyServer(EmulatedDevice& device)
    : device_(device), start_(MonotonicTime()), outgoing_(std::make_unique<Outgoing>()) {
  std::array<char, 256> name{};
  if (openpty(&device_end_, &host_end_, name.data(), nullptr, nullptr) != 0) {
    Fail("cannot make a pseudo-terminal: {}", std::strerror(errno));
  }
  path_ = name.data();
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

void PtyServer::TakeSendings() {
  for (Sending& sending : device_.Advance(Now())) outgoing_->sendings.push_back(std::move(sending));
}

/// When the next byte is due; infinity where none is on its way.
double PtyServer::NextSend() const {
  if (outgoing_->sendings.empty()) return std::numeric_limits<double>::infinity();
  const Sending& first = outgoing_->sendings.front();
  // In pieces of up to 16 bytes, as a UART hands them over.
  const std::size_t piece = std::min(outgoing_->sent + 16, first.bytes.size());
  return first.start + static_cast<double>(piece) * first.byte_time;
}

void PtyServer::SendDue() {
  while (NextSend() <= Now()) {
    Sending& first = outgoing_->sendings.front();
    std::size_t due = first.bytes.size();
    if (first.byte_time > 0.0) {
      due = std::min(due, static_cast<std::size_t>(std::max(0.0, (Now() - first.start) / first.byte_time)));
    }
    Bytes piece(first.bytes.begin() + static_cast<std::ptrdiff_t>(outgoing_->sent),
                first.bytes.begin() + static_cast<std::ptrdiff_t>(std::max(due, outgoing_->sent)));
    if (first.baud != HostBaud()) {
      for (std::uint8_t& byte : piece) byte = static_cast<std::uint8_t>(outgoing_->noise() & 0xFF);
    }
    // A program that does not read loses bytes, as with a serial port.
    if (write(device_end_, piece.data(), piece.size()) < 0 && errno != EAGAIN) {
      Fail("cannot write to {}: {}", path_, std::strerror(errno));
    }
    outgoing_->sent += piece.size();
    if (outgoing_->sent < first.bytes.size()) break;
    outgoing_->sendings.pop_front();
    outgoing_->sent = 0;
  }
}

void PtyServer::Serve(const std::stop_token& stop, double poll_time) {
  std::array<std::uint8_t, 4096> buffer;
  while (!stop.stop_requested()) {
    TakeSendings();
    SendDue();
    const double next = std::min({device_.NextTime(), NextSend(), Now() + poll_time});
    pollfd input{device_end_, POLLIN, 0};
    const double wait = std::ceil(std::max(0.0, next - Now()) * 1000.0);
    if (poll(&input, 1, static_cast<int>(wait)) <= 0 || (input.revents & POLLIN) == 0) continue;
    const ssize_t count = read(device_end_, buffer.data(), buffer.size());
    if (count <= 0) continue;
    TakeSendings();
    device_.Receive(ByteView(buffer.data(), static_cast<std::size_t>(count)), HostBaud(), Now());
  }
}

}  // namespace ariadne::drivers
