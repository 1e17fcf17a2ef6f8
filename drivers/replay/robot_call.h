#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "drivers/robot.h"

namespace ariadne::drivers {

// The calls of a Robot, each with its argument and its answer.
struct NowCall {
  double time = 0.0;  // the answer [s]
};
struct MountingCall {
  slam::Pose3 T_base_laser;  // the answer
};
struct ScanCall {
  slam::Scan scan;  // the answer
};
struct SweepCall {
  slam::LaserSweep sweep;  // the answer
};
struct SafetySweepsCall {
  std::vector<SafetySweep> sweeps;  // the answer
};
struct StateCall {
  RobotState state;  // the answer
};
struct DriveCall {
  Velocity velocity;  // the argument
};
struct WaitCall {
  double until = 0.0;  // the argument [s]
};
/// Not a call: what the mission wants to be on the log.
struct Note {
  std::string text;
};

/// The kinds of RobotCall, in the order of its alternatives; their numbers are those of the files.
enum class CallKind : std::uint8_t {
  kNow,
  kMounting,
  kScan,
  kSweep,
  kSafetySweeps,
  kState,
  kDrive,
  kWait,
  kNote
};

using RobotCall = std::variant<NowCall, MountingCall, ScanCall, SweepCall, SafetySweepsCall, StateCall,
                               DriveCall, WaitCall, Note>;

inline CallKind KindOf(const RobotCall& call) { return static_cast<CallKind>(call.index()); }

/// For a sentence, with the argument in all its digits: "Drive(0.25 m/s, 0.5 rad/s)".
std::string Describe(const RobotCall& call);

/// Whether two calls ask for the same: the same kind, and arguments that are equal bit by bit. Answers, and
/// the texts of notes, do not count.
bool AskTheSame(const RobotCall& a, const RobotCall& b);

}  // namespace ariadne::drivers
