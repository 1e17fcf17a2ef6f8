#include "drivers/replay/call_bytes.h"

#include <array>
#include <utility>

#include "drivers/replay/byte_fields.h"
#include "slam/io/lzf.h"

namespace ariadne::drivers {
namespace {

constexpr std::uint8_t kCompressedFlag = 0x80;

// The fields of each record, in the order of the file, for reading and for writing.

template <typename Bytes, typename Pose3>
void PoseFields(Bytes& bytes, Pose3& pose) {
  for (const int i : {3, 0, 1, 2}) bytes.Number(pose.rotation.coeffs()[i]);  // w first
  for (int i = 0; i < 3; ++i) bytes.Number(pose.translation[i]);
}

template <typename Bytes, typename ScannerModel>
void ScannerFields(Bytes& bytes, ScannerModel& scanner) {
  bytes.Number(scanner.first_angle);
  bytes.Number(scanner.angle_step);
  bytes.Number(scanner.turns_per_sweep);
  bytes.Number(scanner.turn_period);
}

template <typename Bytes, typename LaserSweep>
void SweepFields(Bytes& bytes, LaserSweep& sweep) {
  bytes.Number(sweep.stamp);
  bytes.Number(sweep.pitch);
  bytes.Number(sweep.pitch_rate);
  bytes.Floats(sweep.ranges);
  bytes.Floats(sweep.reflectance);
}

template <typename Bytes, typename Odometry>
void OdometryFields(Bytes& bytes, Odometry& odometry) {
  bytes.Number(odometry.T_odom_base.angle);
  for (int i = 0; i < 2; ++i) bytes.Number(odometry.T_odom_base.translation[i]);
  for (int i = 0; i < 9; ++i) bytes.Number(odometry.covariance(i / 3, i % 3));
}

template <typename Bytes, typename Velocity>
void VelocityFields(Bytes& bytes, Velocity& velocity) {
  bytes.Number(velocity.forward);
  bytes.Number(velocity.turning);
}

template <typename Bytes, typename Scan>
void ScanFields(Bytes& bytes, Scan& scan) {
  ScannerFields(bytes, scan.scanner);
  OdometryFields(bytes, scan.odometry);
  bytes.List(scan.sweeps, [](auto& inner, auto& sweep) { SweepFields(inner, sweep); });
}

template <typename Bytes, typename SafetySweeps>
void SafetySweepsFields(Bytes& bytes, SafetySweeps& sweeps) {
  bytes.List(sweeps, [](auto& inner, auto& safety) {
    PoseFields(inner, safety.T_base_laser);
    ScannerFields(inner, safety.scanner);
    SweepFields(inner, safety.sweep);
  });
}

template <typename Bytes, typename RobotState>
void StateFields(Bytes& bytes, RobotState& state) {
  bytes.Number(state.stamp);
  OdometryFields(bytes, state.odometry);
  VelocityFields(bytes, state.velocity);
  bytes.Flag(state.blocked);
}

template <typename Bytes, typename Call>
void CallFields(Bytes& bytes, Call& call) {
  using Plain = std::remove_const_t<Call>;
  if constexpr (std::is_same_v<Plain, NowCall>) bytes.Number(call.time);
  if constexpr (std::is_same_v<Plain, MountingCall>) PoseFields(bytes, call.T_base_laser);
  if constexpr (std::is_same_v<Plain, ScanCall>) ScanFields(bytes, call.scan);
  if constexpr (std::is_same_v<Plain, SweepCall>) SweepFields(bytes, call.sweep);
  if constexpr (std::is_same_v<Plain, SafetySweepsCall>) SafetySweepsFields(bytes, call.sweeps);
  if constexpr (std::is_same_v<Plain, StateCall>) StateFields(bytes, call.state);
  if constexpr (std::is_same_v<Plain, DriveCall>) VelocityFields(bytes, call.velocity);
  if constexpr (std::is_same_v<Plain, WaitCall>) bytes.Number(call.until);
  if constexpr (std::is_same_v<Plain, Note>) bytes.Rest(call.text);
}

template <std::size_t... kKinds>
RobotCall EmptyCall(CallKind kind, std::index_sequence<kKinds...>) {
  const std::array<RobotCall, sizeof...(kKinds)> calls{
      RobotCall(std::variant_alternative_t<kKinds, RobotCall>())...};
  return calls[static_cast<std::size_t>(kind)];
}

std::string FieldsOf(const RobotCall& call) {
  FieldWriter bytes;
  std::visit([&](const auto& kind) { CallFields(bytes, kind); }, call);
  return bytes.bytes();
}

/// Nothing where it would not be shorter.
std::optional<std::string> Compressed(const std::string& fields) {
  const std::vector<char> compressed = slam::LzfCompressed(fields);
  if (compressed.empty() || compressed.size() + sizeof(std::uint32_t) >= fields.size()) return std::nullopt;
  FieldWriter bytes;
  bytes.Number(static_cast<std::uint32_t>(fields.size()));
  bytes.Rest(std::string(compressed.begin(), compressed.end()));
  return bytes.bytes();
}

std::string Decompressed(std::string_view bytes) {
  FieldReader reader(bytes);
  std::uint32_t size = 0;
  std::string compressed;
  reader.Number(size);
  reader.Rest(compressed);
  if (size > slam::LargestLzfOriginal(compressed.size())) Fail("the size of the record is damaged");
  const auto fields = slam::LzfDecompressed(compressed, size);
  if (!fields) Fail("the compressed record is damaged");
  return {fields->begin(), fields->end()};
}

}  // namespace

std::string EncodeCall(const RobotCall& call) {
  const auto kind = static_cast<std::uint8_t>(KindOf(call));
  const std::string fields = FieldsOf(call);
  if (const auto compressed = Compressed(fields)) {
    return static_cast<char>(kind | kCompressedFlag) + *compressed;
  }
  return static_cast<char>(kind) + fields;
}

std::optional<CallKind> KindOfBytes(std::string_view bytes) {
  if (bytes.empty()) return std::nullopt;
  const auto kind = static_cast<std::uint8_t>(static_cast<std::uint8_t>(bytes.front()) & ~kCompressedFlag);
  if (kind >= std::variant_size_v<RobotCall>) return std::nullopt;
  return static_cast<CallKind>(kind);
}

RobotCall DecodeCall(std::string_view bytes) {
  const std::optional<CallKind> kind = KindOfBytes(bytes);
  if (!kind) Fail("the kind of the record is not known");
  const bool compressed = (static_cast<std::uint8_t>(bytes.front()) & kCompressedFlag) != 0;
  const std::string fields = compressed ? Decompressed(bytes.substr(1)) : std::string(bytes.substr(1));
  FieldReader reader(fields);
  RobotCall call = EmptyCall(*kind, std::make_index_sequence<std::variant_size_v<RobotCall>>());
  std::visit([&](auto& alternative) { CallFields(reader, alternative); }, call);
  reader.Finish();
  return call;
}

}  // namespace ariadne::drivers
