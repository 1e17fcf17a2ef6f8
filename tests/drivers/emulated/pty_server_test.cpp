// The one test of the scanner in real time: the driver opens a pseudo-terminal like a serial port.
#include "drivers/emulated/pty_server.h"

#include <gtest/gtest.h>

#include <thread>

#include "drivers/emulated/emulated_lms200.h"
#include "drivers/hardware/lms200/lms200.h"
#include "drivers/hardware/serial_port.h"

namespace ariadne::drivers {
namespace {

slam::LaserSweep Ramp(double, const slam::ScannerModel&, std::size_t beams) {
  slam::LaserSweep sweep;
  for (std::size_t i = 0; i < beams; ++i) sweep.ranges.push_back(0.01F * static_cast<float>(i));
  return sweep;
}

class PtyServerTest : public testing::Test {
 protected:
  static EmulatedLms200Options Quick() {
    EmulatedLms200Options options;
    options.boot_time = 0.0;
    options.mode_delay = 0.002;
    return options;
  }

  EmulatedLms200 device_{Quick(), Ramp};
  PtyServer server_{device_};
  std::jthread thread_{[this](const std::stop_token& stop) { server_.Serve(stop); }};
};

TEST_F(PtyServerTest, ServesADriverOverASerialPort) {
  Lms200Options options;
  options.resolution = 1.0;
  Lms200 driver(OpenSerialPort(server_.path(), 9600), options);
  driver.StartStream();
  for (int i = 0; i < 10; ++i) {
    const Lms200Sweep sweep = driver.NextSweep();
    ASSERT_EQ(sweep.sweep.ranges.size(), 181U);
    for (std::size_t beam = 0; beam < 181; ++beam) {
      ASSERT_FLOAT_EQ(sweep.sweep.ranges[beam], 0.01F * static_cast<float>(beam));
    }
  }
}

TEST_F(PtyServerTest, LetsAProgramComeAndGo) {
  Lms200Options options;
  options.resolution = 1.0;
  for (const int baud : {38400, 500000}) {
    options.baud = baud;
    Lms200 driver(OpenSerialPort(server_.path(), 9600), options);
    driver.Connect();
    EXPECT_EQ(driver.AskStatus().baud, baud);
  }
}

}  // namespace
}  // namespace ariadne::drivers
