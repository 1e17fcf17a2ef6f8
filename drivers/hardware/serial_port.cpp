#include "drivers/hardware/serial_port.h"

#include <linux/serial.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <termios.h>

#include <algorithm>
#include <array>
#include <boost/asio.hpp>
#include <chrono>

namespace ariadne::drivers {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;
using Clock = std::chrono::steady_clock;

const char* AdviceFor(const error_code& error) {
  if (error == boost::system::errc::no_such_file_or_directory) {
    return "is the adapter plugged in? `ariadne devices` lists the ports";
  }
  if (error == boost::system::errc::permission_denied) return "is the user in the group dialout?";
  return "see what else uses it, and its cable";
}

class SerialPort : public ByteStream {
 public:
  SerialPort(std::string path, int baud) : path_(std::move(path)) {
    error_code error;
    port_.open(path_, error);
    if (error) Fail("cannot open {}: {}; {}", path_, error.message(), AdviceFor(error));
    // Two programs that talk to one device confuse it; the lock ends with the program.
    if (flock(port_.native_handle(), LOCK_EX | LOCK_NB) != 0) {
      Fail("{} is in use by another program; stop that one first", path_);
    }
    SetFormat();
    SetLowLatency();
    SetBaud(baud);
  }

  std::string name() const override { return path_; }
  double Now() const override {
    return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
  }
  int baud() const override { return baud_; }

  Bytes Read(double deadline) override;
  void Write(ByteView bytes) override;
  void SetBaud(int baud) override;

 private:
  void SetFormat();
  void SetLowLatency();
  [[noreturn]] void FailRead(const error_code& error) const {
    Fail("{} is gone: {}; see its cable, and start again", path_, error.message());
  }

  std::string path_;
  int baud_ = 0;
  asio::io_context context_;
  asio::serial_port port_{context_};
  std::array<std::uint8_t, 4096> buffer_;
};

void SerialPort::SetFormat() {
  using Base = asio::serial_port_base;
  error_code error;
  port_.set_option(Base::character_size(8), error);
  if (!error) port_.set_option(Base::parity(Base::parity::none), error);
  if (!error) port_.set_option(Base::stop_bits(Base::stop_bits::one), error);
  if (!error) port_.set_option(Base::flow_control(Base::flow_control::none), error);
  if (error) Fail("{} is no serial port: {}", path_, error.message());
}

/// Adapters keep bytes back for up to 16 ms unless they are told not to, which blurs the times of sweeps.
/// Not all ports can be told, and then they are used as they are.
void SerialPort::SetLowLatency() {
  serial_struct settings{};
  if (ioctl(port_.native_handle(), TIOCGSERIAL, &settings) != 0) return;
  settings.flags |= ASYNC_LOW_LATENCY;
  ioctl(port_.native_handle(), TIOCSSERIAL, &settings);
}

void SerialPort::SetBaud(int baud) {
  error_code error;
  if (baud_ != 0) tcdrain(port_.native_handle());
  port_.set_option(asio::serial_port_base::baud_rate(static_cast<unsigned>(baud)), error);
  if (error) {
    Fail("{} cannot have {} baud: {}; 500000 baud needs an RS-422 adapter", path_, baud, error.message());
  }
  tcflush(port_.native_handle(), TCIFLUSH);
  baud_ = baud;
}

Bytes SerialPort::Read(double deadline) {
  error_code error = asio::error::would_block;
  std::size_t count = 0;
  port_.async_read_some(asio::buffer(buffer_), [&](const error_code& result, std::size_t size) {
    error = result;
    count = size;
  });
  context_.restart();
  context_.run_for(std::chrono::duration_cast<Clock::duration>(
      std::chrono::duration<double>(std::max(0.0, deadline - Now()))));
  if (error == asio::error::would_block) {  // nothing came
    port_.cancel();
    context_.restart();
    context_.run();
  }
  if (error && error != asio::error::operation_aborted) FailRead(error);
  return {buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(count)};
}

void SerialPort::Write(ByteView bytes) {
  error_code error;
  asio::write(port_, asio::buffer(bytes.data(), bytes.size()), error);
  if (error) Fail("cannot write to {}: {}; see its cable, and start again", path_, error.message());
}

}  // namespace

std::unique_ptr<ByteStream> OpenSerialPort(const std::string& path, int baud) {
  return std::make_unique<SerialPort>(path, baud);
}

}  // namespace ariadne::drivers
