// In real time, for seconds: what the driver costs, and whether the emulated line is as slow as a real one.
#include <gtest/gtest.h>

#include <ctime>
#include <thread>

#include "drivers/emulated/emulated_lms200.h"
#include "drivers/emulated/pty_server.h"
#include "drivers/hardware/lms200/lms200.h"
#include "drivers/hardware/serial_port.h"

namespace ariadne::drivers {
namespace {

#if defined(NDEBUG) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
constexpr double kLargestShare = 0.02;  // of one core, at 75 sweeps/s
#else
constexpr double kLargestShare = 0.5;
#endif

slam::LaserSweep Nothing(double, const slam::ScannerModel&, std::size_t beams) {
  slam::LaserSweep sweep;
  sweep.ranges.assign(beams, 3.0F);
  return sweep;
}

double CpuTimeOfThread() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

struct Load {
  double per_second = 0.0;  // sweeps
  double cpu_share = 0.0;   // of the driver's thread
};

Load StreamFor(double seconds, bool paced, int baud, double resolution) {
  EmulatedLms200Options device_options;
  device_options.boot_time = 0.0;
  device_options.paced = paced;
  EmulatedLms200 device(device_options, Nothing);
  PtyServer server(device);
  const std::jthread thread([&](const std::stop_token& stop) { server.Serve(stop); });
  Lms200Options options;
  options.baud = baud;
  options.resolution = resolution;
  Lms200 driver(OpenSerialPort(server.path(), 9600), options);
  driver.StartStream();
  const double first = driver.NextSweep().sweep.stamp;
  const double start = driver.Now();
  const double cpu_start = CpuTimeOfThread();
  double last = first;
  int sweeps = 0;
  for (; last < first + seconds; ++sweeps) last = driver.NextSweep().sweep.stamp;
  return {sweeps / (last - first), (CpuTimeOfThread() - cpu_start) / (driver.Now() - start)};
}

TEST(PtyLoad, Of75SweepsPerSecondIsSmall) {
  const Load load = StreamFor(4.0, false, 500000, 1.0);
  EXPECT_GT(load.per_second, 70.0);
  EXPECT_LT(load.cpu_share, kLargestShare);
  RecordProperty("cpu_share", std::to_string(load.cpu_share));
  RecordProperty("per_second", std::to_string(load.per_second));
}

/// Spec 9.3: 4.7 telegrams/s of 361 values were measured at 38400 baud.
TEST(PtyLoad, At38400BaudIsThatOfTheDevice) {
  const Load load = StreamFor(4.0, true, 38400, 0.5);
  EXPECT_NEAR(load.per_second, 4.69, 0.05 * 4.69);
  RecordProperty("per_second", std::to_string(load.per_second));
}

}  // namespace
}  // namespace ariadne::drivers
