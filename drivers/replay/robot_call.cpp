#include "drivers/replay/robot_call.h"

#include <fmt/format.h>

#include <bit>

namespace ariadne::drivers {
namespace {

bool SameBits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

}  // namespace

std::string Describe(const RobotCall& call) {
  switch (KindOf(call)) {
    case CallKind::kNow:
      return "Now()";
    case CallKind::kMounting:
      return "T_base_laser()";
    case CallKind::kScan:
      return "TakeScan()";
    case CallKind::kSweep:
      return "TakeSweep()";
    case CallKind::kSafetySweeps:
      return "TakeSafetySweeps()";
    case CallKind::kState:
      return "State()";
    case CallKind::kDrive: {
      const Velocity& velocity = std::get<DriveCall>(call).velocity;
      return fmt::format("Drive({} m/s, {} rad/s)", velocity.forward, velocity.turning);
    }
    case CallKind::kWait:
      return fmt::format("WaitUntil({} s)", std::get<WaitCall>(call).until);
    case CallKind::kNote:
      break;
  }
  return fmt::format("the note \"{}\"", std::get<Note>(call).text);
}

bool AskTheSame(const RobotCall& a, const RobotCall& b) {
  if (a.index() != b.index()) return false;
  if (const auto* drive = std::get_if<DriveCall>(&a)) {
    const Velocity& other = std::get<DriveCall>(b).velocity;
    return SameBits(drive->velocity.forward, other.forward) &&
           SameBits(drive->velocity.turning, other.turning);
  }
  if (const auto* wait = std::get_if<WaitCall>(&a)) {
    return SameBits(wait->until, std::get<WaitCall>(b).until);
  }
  return true;
}

}  // namespace ariadne::drivers
