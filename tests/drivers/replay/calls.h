#pragma once

#include <bit>
#include <cmath>
#include <string>
#include <vector>

#include "drivers/replay/robot_call.h"
#include "slam/base/random.h"

namespace ariadne::drivers {

/// Numbers of any bits: infinities, subnormals and each NaN among them.
inline double AnyDouble(RandomStream& stream) { return std::bit_cast<double>(stream()); }

inline std::vector<float> AnyFloats(RandomStream& stream) {
  std::vector<float> numbers(stream() % 40);
  for (float& number : numbers) number = std::bit_cast<float>(static_cast<std::uint32_t>(stream()));
  return numbers;
}

inline slam::LaserSweep AnySweep(RandomStream& stream) {
  return {AnyDouble(stream), AnyDouble(stream), AnyDouble(stream), AnyFloats(stream), AnyFloats(stream)};
}

/// As a scanner measures: millimetres along walls, and nothing here and there.
inline slam::LaserSweep LikelySweep(RandomStream& stream, std::size_t beams) {
  slam::LaserSweep sweep{DrawUniform(stream, 0.0, 1000.0), 0.1, 0.0, {}, {}};
  double range = 2.0;
  for (std::size_t i = 0; i < beams; ++i) {
    range += i % 50 == 0 ? DrawUniform(stream, 0.0, 8.0) : DrawNormal(stream, 0.0, 0.005);
    const bool lost = stream() % 30 == 0;
    sweep.ranges.push_back(lost ? slam::LaserSweep::kNoReturn
                                : static_cast<float>(std::round(range / 0.001) * 0.001));
    sweep.reflectance.push_back(static_cast<float>(static_cast<double>(stream() % 256) / 255.0));
  }
  return sweep;
}

inline slam::ScannerModel AnyScanner(RandomStream& stream) {
  return {AnyDouble(stream), AnyDouble(stream), static_cast<int>(stream()), AnyDouble(stream)};
}

inline slam::Odometry AnyOdometry(RandomStream& stream) {
  slam::Odometry odometry{{AnyDouble(stream), {AnyDouble(stream), AnyDouble(stream)}}, {}};
  for (int i = 0; i < 9; ++i) odometry.covariance(i) = AnyDouble(stream);
  return odometry;
}

inline slam::Pose3 AnyPose(RandomStream& stream) {
  slam::Pose3 pose;
  for (int i = 0; i < 4; ++i) pose.rotation.coeffs()[i] = AnyDouble(stream);
  for (int i = 0; i < 3; ++i) pose.translation[i] = AnyDouble(stream);
  return pose;
}

inline RobotCall AnyCall(RandomStream& stream, CallKind kind) {
  const auto sweeps = [&] {
    std::vector<slam::LaserSweep> some(stream() % 4);
    for (slam::LaserSweep& sweep : some) sweep = AnySweep(stream);
    return some;
  };
  switch (kind) {
    case CallKind::kNow:
      return NowCall{AnyDouble(stream)};
    case CallKind::kMounting:
      return MountingCall{AnyPose(stream)};
    case CallKind::kScan:
      return ScanCall{{AnyScanner(stream), AnyOdometry(stream), sweeps()}};
    case CallKind::kSweep:
      return SweepCall{AnySweep(stream)};
    case CallKind::kSafetySweeps: {
      SafetySweepsCall call;
      for (slam::LaserSweep& sweep : sweeps()) {
        call.sweeps.push_back({AnyPose(stream), AnyScanner(stream), std::move(sweep)});
      }
      return call;
    }
    case CallKind::kState:
      return StateCall{{AnyDouble(stream),
                        AnyOdometry(stream),
                        {AnyDouble(stream), AnyDouble(stream)},
                        stream() % 2 == 0}};
    case CallKind::kDrive:
      return DriveCall{{AnyDouble(stream), AnyDouble(stream)}};
    case CallKind::kWait:
      return WaitCall{AnyDouble(stream)};
    case CallKind::kNote:
      break;
  }
  return Note{std::string(stream() % 20, static_cast<char>(stream()))};
}

inline RobotCall AnyCall(RandomStream& stream) {
  return AnyCall(stream, static_cast<CallKind>(stream() % std::variant_size_v<RobotCall>));
}

}  // namespace ariadne::drivers
