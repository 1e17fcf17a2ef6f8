#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "drivers/emulated/emulated_line.h"
#include "drivers/emulated/emulated_lms200.h"
#include "drivers/hardware/lms200/lms200.h"

namespace ariadne::drivers {

/// What a scanner was given to measure: ranges that no other sweep has, in whole centimetres, some without
/// an echo; and it remembers them.
class SweepLog {
 public:
  slam::LaserSweep Take(double stamp, const slam::ScannerModel& scanner, std::size_t beams) {
    slam::LaserSweep sweep;
    sweep.stamp = stamp;
    for (std::size_t beam = 0; beam < beams; ++beam) {
      const std::uint64_t draw = stream_();
      const bool echo = draw % 17 != 0;
      sweep.ranges.push_back(echo ? static_cast<float>(50 + draw % 700) * 0.01F
                                  : slam::LaserSweep::kNoReturn);
      sweep.reflectance.push_back(static_cast<float>((draw >> 20) % 8) / 7.0F);
    }
    first_angles.push_back(scanner.first_angle);
    sweeps.push_back(sweep);
    return sweep;
  }

  /// The sweep that began next to `stamp`.
  const slam::LaserSweep& At(double stamp) const {
    const slam::LaserSweep* best = &sweeps.back();
    // Sweeps are in the order of their stamps, and what is asked for is among the last ones.
    for (auto sweep = sweeps.rbegin(); sweep != sweeps.rend(); ++sweep) {
      if (std::abs(sweep->stamp - stamp) > std::abs(best->stamp - stamp)) break;
      best = &*sweep;
    }
    return *best;
  }

  std::vector<slam::LaserSweep> sweeps;
  std::vector<double> first_angles;

 private:
  RandomStream stream_ = NamedStream(1, "sweep log");
};

/// A scanner, a line and a driver.
struct Lms200Bench {
  explicit Lms200Bench(const Lms200Options& driver_options = {},
                       const EmulatedLms200Options& device_options = {},
                       EmulatedLineOptions line_options = {})
      : device(device_options, [this](double stamp, const slam::ScannerModel& scanner,
                                      std::size_t beams) { return log.Take(stamp, scanner, beams); }),
        turn_period(device_options.turn_period) {
    if (!line_options.time) line_options.time = std::make_shared<VirtualTime>();
    time = line_options.time;
    auto owned = std::make_unique<EmulatedLine>(device, line_options);
    line = owned.get();
    driver = std::make_unique<Lms200>(std::move(owned), driver_options);
  }

  /// Whether all ranges are those of the sweep that began at its stamp, which is right to `tolerance` [s].
  testing::AssertionResult IsRight(const Lms200Sweep& taken, double tolerance = 0.002) const {
    const std::size_t parts = taken.sweep.ranges.size() == 721 ? 4 : 1;
    for (std::size_t part = 0; part < parts; ++part) {
      const double stamp = taken.sweep.stamp + static_cast<double>(part) * turn_period;
      const slam::LaserSweep& truth = log.At(stamp);
      if (std::abs(truth.stamp - stamp) > tolerance) {
        return testing::AssertionFailure()
               << "stamp " << stamp << ", but the next sweep is of " << truth.stamp;
      }
      for (std::size_t i = 0; i < truth.ranges.size(); ++i) {
        const float range = taken.sweep.ranges[i * parts + part];
        const bool both_none = std::isnan(range) && std::isnan(truth.ranges[i]);
        if (!both_none && !(std::abs(range - truth.ranges[i]) < 1e-4F)) {
          return testing::AssertionFailure() << "beam " << i * parts + part << " of " << truth.stamp
                                             << " is " << range << " instead of " << truth.ranges[i];
        }
      }
    }
    return testing::AssertionSuccess();
  }

  SweepLog log;
  EmulatedLms200 device;
  double turn_period;
  std::shared_ptr<VirtualTime> time;  // to be put forward while nobody reads
  EmulatedLine* line = nullptr;
  std::unique_ptr<Lms200> driver;
};

inline Lms200Options With(int field_of_view, double resolution, int baud = 500000) {
  Lms200Options options;
  options.field_of_view = field_of_view;
  options.resolution = resolution;
  options.baud = baud;
  return options;
}

}  // namespace ariadne::drivers
