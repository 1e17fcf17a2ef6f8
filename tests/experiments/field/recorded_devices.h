#pragma once

#include <filesystem>
#include <memory>

#include "drivers/emulated/emulated_line.h"
#include "drivers/emulated/emulated_lms200.h"
#include "drivers/emulated/emulated_motors.h"
#include "drivers/emulated/emulated_servo.h"
#include "drivers/hardware/dynamixel/servo.h"
#include "drivers/hardware/line_log.h"
#include "drivers/hardware/lms200/lms200.h"
#include "drivers/hardware/roboclaw/motors.h"

namespace ariadne::experiments {

/// A scanner (line 0), a servo (1) and wheels (2), emulated, whose lines are recorded. Each line has a time
/// of its own.
struct RecordedDevices {
  explicit RecordedDevices(const std::filesystem::path& name) : log(name) {}

  std::unique_ptr<drivers::ByteStream> LineTo(drivers::EmulatedDevice& device, std::uint8_t number) {
    auto line = std::make_unique<drivers::EmulatedLine>(device);
    lines[number] = line.get();
    return std::make_unique<drivers::RecordingStream>(
        std::move(line), [this, number](const drivers::LineRecord& record) { log.Add(number, record); });
  }

  static drivers::EmulatedLms200Options Booted() {
    drivers::EmulatedLms200Options options;
    options.boot_time = 0.0;
    return options;
  }
  static drivers::Lms200Options Coarse() {
    drivers::Lms200Options options;
    options.resolution = 1.0;
    return options;
  }
  /// Beam i sees 1 m + i cm.
  static slam::LaserSweep Ramp(double, const slam::ScannerModel&, std::size_t beams) {
    slam::LaserSweep sweep;
    for (std::size_t i = 0; i < beams; ++i) sweep.ranges.push_back(1.0F + 0.01F * static_cast<float>(i));
    return sweep;
  }

  drivers::LineLogWriter log;
  std::array<drivers::EmulatedLine*, 3> lines{};
  drivers::EmulatedLms200 scanner_device{Booted(), Ramp};
  drivers::EmulatedServo servo_device;
  drivers::EmulatedMotors motor_device;
  drivers::Lms200 scanner{LineTo(scanner_device, 0), Coarse()};
  drivers::dynamixel::Servo servo{LineTo(servo_device, 1), {}};
  drivers::roboclaw::Motors motors{LineTo(motor_device, 2), {}};
};

}  // namespace ariadne::experiments
