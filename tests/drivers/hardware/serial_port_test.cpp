#include "drivers/hardware/serial_port.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pty.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>

#include "tests/support/error_of.h"

namespace ariadne::drivers {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// A pseudo-terminal, whose other side is a file.
class SerialPortTest : public testing::Test {
 protected:
  SerialPortTest() {
    int slave = -1;
    std::array<char, 200> name{};
    if (openpty(&device_, &slave, name.data(), nullptr, nullptr) != 0)
      ADD_FAILURE() << "no pseudo-terminals";
    path_ = name.data();
    close(slave);
  }
  ~SerialPortTest() override {
    if (device_ >= 0) close(device_);
  }

  void DeviceWrites(const Bytes& bytes) {
    ASSERT_EQ(write(device_, bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
  }
  Bytes DeviceReads() {
    Bytes bytes(1000);
    bytes.resize(static_cast<std::size_t>(std::max<ssize_t>(0, read(device_, bytes.data(), bytes.size()))));
    return bytes;
  }
  termios Settings() {
    termios settings{};
    tcgetattr(device_, &settings);
    return settings;
  }

  int device_ = -1;
  std::string path_;
};

TEST_F(SerialPortTest, CarriesAllBytesBothWaysUnchanged) {
  const std::unique_ptr<ByteStream> port = OpenSerialPort(path_, 38400);
  Bytes all;
  for (int i = 0; i < 256; ++i) all.push_back(static_cast<std::uint8_t>(i));
  port->Write(all);
  EXPECT_EQ(DeviceReads(), all);
  DeviceWrites(all);
  Bytes read;
  while (read.size() < all.size()) {
    const Bytes more = port->Read(port->Now() + 1.0);
    ASSERT_FALSE(more.empty());
    read.insert(read.end(), more.begin(), more.end());
  }
  EXPECT_EQ(read, all);
}

TEST_F(SerialPortTest, Sets8N1AndTheRate) {
  const std::unique_ptr<ByteStream> port = OpenSerialPort(path_, 9600);
  const termios settings = Settings();
  EXPECT_EQ(settings.c_cflag & CSIZE, static_cast<tcflag_t>(CS8));
  EXPECT_EQ(settings.c_cflag & (PARENB | CSTOPB | CRTSCTS), 0U);
  EXPECT_EQ(settings.c_lflag & (ICANON | ECHO), 0U);
  const std::vector<std::pair<int, speed_t>> rates = {
      {9600, B9600}, {19200, B19200}, {38400, B38400}, {57600, B57600}, {500000, B500000}};
  for (const auto& [baud, speed] : rates) {
    port->SetBaud(baud);
    EXPECT_EQ(port->baud(), baud);
    const termios now = Settings();
    EXPECT_EQ(cfgetospeed(&now), speed) << baud;
  }
  EXPECT_THROW(port->SetBaud(12345), Error);
}

TEST_F(SerialPortTest, ReturnsNothingAtTheDeadline) {
  const std::unique_ptr<ByteStream> port = OpenSerialPort(path_, 38400);
  const double start = port->Now();
  EXPECT_TRUE(port->Read(start - 1.0).empty());
  EXPECT_TRUE(port->Read(start + 0.02).empty());
  EXPECT_GE(port->Now(), start + 0.02);
  DeviceWrites({1, 2});
  EXPECT_EQ(port->Read(start), (Bytes{1, 2}));  // what is there is read after the deadline, too
}

TEST_F(SerialPortTest, ForgetsWhatArrivedAtTheOldRate) {
  const std::unique_ptr<ByteStream> port = OpenSerialPort(path_, 38400);
  DeviceWrites({1, 2, 3});
  port->SetBaud(9600);
  EXPECT_TRUE(port->Read(port->Now() + 0.01).empty());
}

TEST_F(SerialPortTest, IsForOneProgramAtATime) {
  const std::unique_ptr<ByteStream> port = OpenSerialPort(path_, 38400);
  EXPECT_THAT(ErrorOf([&] { OpenSerialPort(path_, 38400); }), HasSubstr(path_ + " is in use"));
}

TEST_F(SerialPortTest, SaysWhenTheAdapterIsPulledOut) {
  const std::unique_ptr<ByteStream> port = OpenSerialPort(path_, 38400);
  close(device_);
  device_ = -1;
  EXPECT_THAT(ErrorOf([&] { port->Read(port->Now() + 1.0); }), HasSubstr(path_ + " is gone"));
}

TEST_F(SerialPortTest, SaysWhatToDoWhereThereIsNoPort) {
  EXPECT_THAT(ErrorOf([] { OpenSerialPort("/dev/no_such_port", 38400); }), HasSubstr("ariadne devices"));
  EXPECT_THAT(ErrorOf([] { OpenSerialPort("/dev/null", 38400); }), HasSubstr("/dev/null"));
}

TEST(ListSerialPorts, PrefersStableNames) {
  const fs::path dev = fs::temp_directory_path() / ("ariadne_ports_" + std::to_string(getpid()));
  fs::create_directories(dev / "serial/by-id");
  for (const char* name : {"ttyUSB0", "ttyUSB1", "tty1", "null"}) std::ofstream(dev / name) << "";
  fs::create_symlink("../../ttyUSB1", dev / "serial/by-id/usb-FTDI-if00");
  const std::vector<SerialPortName> ports = ListSerialPorts(dev.string());
  ASSERT_EQ(ports.size(), 2U);
  EXPECT_EQ(ports[0].path, (dev / "serial/by-id/usb-FTDI-if00").string());
  EXPECT_EQ(ports[0].device, (dev / "ttyUSB1").string());
  EXPECT_EQ(ports[1].path, (dev / "ttyUSB0").string());
  fs::remove_all(dev);
  EXPECT_TRUE(ListSerialPorts(dev.string()).empty());
}

}  // namespace
}  // namespace ariadne::drivers
