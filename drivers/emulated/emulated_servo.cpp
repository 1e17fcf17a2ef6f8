#include "drivers/emulated/emulated_servo.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace ariadne::drivers {
namespace {

using dynamixel::Instruction;
using dynamixel::Place;

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kFastest = 6.0 / kTurn;    // [turns/s]
constexpr double kSteepest = 40.0 / kTurn;  // [turns/s^2]
constexpr double kStep = 0.001;             // of the simulated motion [s]
constexpr double kOverloadAfter = 1.0;      // [s]
constexpr std::uint8_t kOverloadBit = 0x20;
constexpr std::uint8_t kAlertBit = 0x80;

}  // namespace

EmulatedServo::EmulatedServo(const EmulatedServoOptions& options)
    : options_(options), position_(options.position / 360.0) {
  CheckOptions(options_, "emulated_servo.");
  SetDefaults();
}

void EmulatedServo::SetDefaults() {
  table_.fill(0);
  ByteAt(Place::kModel) = static_cast<std::uint8_t>(options_.model & 0xFF);
  table_[1] = static_cast<std::uint8_t>(options_.model >> 8);
  table_[6] = 45;  // firmware
  table_[7] = static_cast<std::uint8_t>(options_.id);
  ByteAt(Place::kOperatingMode) = 3;
  velocity_ = 0.0;
  overload_ = 0.0;
  PutNumber(Place::kGoalPosition,
            static_cast<std::int32_t>(std::lround(position_ * dynamixel::kStepsPerTurn)));
}

std::int32_t EmulatedServo::NumberAt(Place place) const {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    number |= static_cast<std::uint32_t>(table_[static_cast<std::size_t>(place) + i]) << (8 * i);
  }
  return static_cast<std::int32_t>(number);
}

void EmulatedServo::PutNumber(Place place, std::int32_t value) {
  for (std::size_t i = 0; i < 4; ++i) {
    const std::uint32_t byte = static_cast<std::uint32_t>(value) >> (8 * i) & 0xFF;
    table_[static_cast<std::size_t>(place) + i] = static_cast<std::uint8_t>(byte);
  }
}

/// A trapezoid of velocity towards the goal.
void EmulatedServo::Step(double seconds) {
  const double goal = NumberAt(Place::kGoalPosition) / static_cast<double>(dynamixel::kStepsPerTurn);
  const double left = goal - position_;
  const double limit = NumberAt(Place::kProfileVelocity) * dynamixel::kVelocityUnit;
  const double rise = NumberAt(Place::kProfileAcceleration) * dynamixel::kAccelerationUnit;
  const double fastest = limit > 0.0 ? std::min(limit, kFastest) : kFastest;
  const double steepest = rise > 0.0 ? std::min(rise, kSteepest) : kSteepest;
  const double brake = std::sqrt(2.0 * steepest * std::abs(left));  // from which it still stops at the goal
  const double wanted = std::copysign(std::min(fastest, brake), left);
  velocity_ += std::clamp(wanted - velocity_, -steepest * seconds, steepest * seconds);
  if (std::abs(left) <= std::abs(velocity_) * seconds + 1e-6) {
    position_ = goal;
    velocity_ = 0.0;
  } else {
    position_ += velocity_ * seconds;
  }
}

void EmulatedServo::Move(double time) {
  while (now_ < time) {
    const double seconds = std::min(kStep, time - now_);
    now_ += seconds;
    const double goal = NumberAt(Place::kGoalPosition) / static_cast<double>(dynamixel::kStepsPerTurn);
    const bool standing = position_ == goal && velocity_ == 0.0;
    if (ByteAt(Place::kTorqueEnable) == 0 || standing) {
      velocity_ = 0.0;
      now_ = std::max(now_, time);
      memory_.Remember(now_, position_);
      continue;
    }
    if (!stuck_) {
      Step(seconds);
      memory_.Remember(now_, position_);
      continue;
    }
    velocity_ = 0.0;
    overload_ += seconds;
    if (overload_ >= kOverloadAfter) {
      ByteAt(Place::kHardwareError) |= kOverloadBit;
      ByteAt(Place::kTorqueEnable) = 0;
    }
  }
  ByteAt(Place::kMoving) = velocity_ != 0.0 ? 1 : 0;
  const double units = velocity_ / dynamixel::kVelocityUnit;
  PutNumber(Place::kPresentVelocity, static_cast<std::int32_t>(std::lround(units)));
  const double steps = position_ * dynamixel::kStepsPerTurn;
  PutNumber(Place::kPresentPosition, static_cast<std::int32_t>(std::lround(steps)));
}

double EmulatedServo::NextTime() const {
  return sendings_.empty() ? std::numeric_limits<double>::infinity() : now_;
}

std::vector<Sending> EmulatedServo::Advance(double time) {
  if (time >= ready_at_) Move(time);
  return std::exchange(sendings_, {});
}

void EmulatedServo::LosePower(double time, double seconds) {
  Move(time);
  ready_at_ = time + seconds;
  now_ = ready_at_;
  SetDefaults();
  decoder_ = dynamixel::PacketDecoder();
}

void EmulatedServo::Receive(ByteView bytes, int baud, double time) {
  if (time < ready_at_ || baud != options_.baud)
    return;  // other rates are noise, in which there is no packet
  if (options_.echo) sendings_.push_back({time, 10.0 / baud, baud, Bytes(bytes.begin(), bytes.end())});
  decoder_.Push(bytes);
  while (const std::optional<dynamixel::Packet> packet = decoder_.Next()) Execute(*packet, time);
}

void EmulatedServo::Reply(std::uint8_t error, const Bytes& data, double time) {
  if (ByteAt(Place::kHardwareError) != 0) error |= kAlertBit;
  Bytes parameters = {error};
  parameters.insert(parameters.end(), data.begin(), data.end());
  const dynamixel::Packet status{table_[7], static_cast<std::uint8_t>(Instruction::kStatus), parameters};
  const double byte_time = 10.0 / options_.baud;
  const double echoed =
      sendings_.empty()
          ? 0.0
          : sendings_.back().start + byte_time * static_cast<double>(sendings_.back().bytes.size());
  const double start = std::max({time + options_.return_delay, sent_until_, echoed});
  sendings_.push_back({start, byte_time, options_.baud, dynamixel::EncodePacket(status)});
  sent_until_ = start + byte_time * static_cast<double>(sendings_.back().bytes.size());
}

std::uint8_t EmulatedServo::WriteTable(std::size_t address, ByteView data) {
  if (address + data.size() > table_.size()) return 4;
  const bool with_torque = ByteAt(Place::kTorqueEnable) != 0;
  if (with_torque && address < static_cast<std::size_t>(Place::kTorqueEnable))
    return 7;  // the EEPROM is locked
  if (address == static_cast<std::size_t>(Place::kTorqueEnable) && ByteAt(Place::kHardwareError) != 0 &&
      data[0] != 0) {
    return 7;
  }
  if (address == static_cast<std::size_t>(Place::kGoalPosition) && data.size() == 4) {
    const std::uint32_t goal =
        data[0] | data[1] << 8 | data[2] << 16 | static_cast<std::uint32_t>(data[3]) << 24;
    if (goal >= static_cast<std::uint32_t>(dynamixel::kStepsPerTurn)) return 6;
  }
  std::copy(data.begin(), data.end(), table_.begin() + static_cast<std::ptrdiff_t>(address));
  return 0;
}

void EmulatedServo::SyncWrite(ByteView parameters) {
  if (parameters.size() < 4) return;
  const auto address = static_cast<std::size_t>(parameters[0] | parameters[1] << 8);
  const auto size = static_cast<std::size_t>(parameters[2] | parameters[3] << 8);
  for (std::size_t at = 4; at + 1 + size <= parameters.size(); at += 1 + size) {
    if (parameters[at] == table_[7]) WriteTable(address, parameters.subspan(at + 1, size));
  }
}

void EmulatedServo::Execute(const dynamixel::Packet& packet, double time) {
  const ByteView parameters = packet.parameters;
  const auto instruction = static_cast<Instruction>(packet.instruction);
  const bool all = packet.id == dynamixel::kBroadcast;
  if (instruction == Instruction::kStatus) return;  // of another servo on the bus
  if (instruction == Instruction::kSyncWrite && all) return SyncWrite(parameters);
  if (packet.id != table_[7] && !(all && instruction == Instruction::kPing)) return;
  if (instruction == Instruction::kPing) return Reply(0, {table_[0], table_[1], table_[6]}, time);
  if (instruction == Instruction::kReboot) {
    Reply(0, {}, time);
    SetDefaults();
    return;
  }
  const bool reads = instruction == Instruction::kRead;
  if (!reads && instruction != Instruction::kWrite) return Reply(2, {}, time);
  if (parameters.size() < 3 || (reads && parameters.size() != 4)) return Reply(5, {}, time);
  const auto address = static_cast<std::size_t>(parameters[0] | parameters[1] << 8);
  if (!reads) return Reply(WriteTable(address, parameters.subspan(2)), {}, time);
  const auto count = static_cast<std::size_t>(parameters[2] | parameters[3] << 8);
  if (address + count > table_.size()) return Reply(4, {}, time);
  const auto begin = table_.begin() + static_cast<std::ptrdiff_t>(address);
  Reply(0, Bytes(begin, begin + static_cast<std::ptrdiff_t>(count)), time);
}

}  // namespace ariadne::drivers
