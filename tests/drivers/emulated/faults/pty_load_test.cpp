// In real time, for seconds: what the driver costs, and whether the emulated line is as slow as a real one.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
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

/// Other work on the machine only ever makes it worse: the first of a few tries that is as it should be
/// counts, and on a machine that is busy throughout nothing can be said.
template <typename Good>
void ExpectOnce(const Good& is_good, double seconds, bool paced, int baud, double resolution) {
  constexpr int kTries = 4;
  Load load;
  for (int i = 0; i < kTries; ++i) {
    load = StreamFor(seconds, paced, baud, resolution);
    if (is_good(load)) return;
  }
  double busy = 0.0;
  if (getloadavg(&busy, 1) == 1 && busy > 0.75 * std::thread::hardware_concurrency())
    GTEST_SKIP() << "the machine is busy with other things";
  ADD_FAILURE() << load.per_second << " sweeps/s, " << load.cpu_share << " of a core";
}

TEST(PtyLoad, Of75SweepsPerSecondIsSmall) {
  ExpectOnce([](const Load& load) { return load.per_second > 70.0 && load.cpu_share < kLargestShare; }, 3.0,
             false, 500000, 1.0);
}

/// Spec 9.3: 4.7 telegrams/s of 361 values were measured at 38400 baud.
TEST(PtyLoad, At38400BaudIsThatOfTheDevice) {
  ExpectOnce([](const Load& load) { return std::abs(load.per_second - 4.69) < 0.05 * 4.69; }, 4.0, true,
             38400, 0.5);
}

}  // namespace
}  // namespace ariadne::drivers
