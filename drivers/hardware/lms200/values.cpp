#include "drivers/hardware/lms200/values.h"

#include <algorithm>
#include <array>

#include "drivers/hardware/lms200/telegram.h"

namespace ariadne::drivers::lms200 {
namespace {

constexpr std::uint16_t kCountMask = 0x03FF;
constexpr int kOffsetShift = 11;
constexpr std::uint16_t kPartialBit = 0x2000;
constexpr int kUnitShift = 14;

constexpr std::uint8_t kAll = ReplyTo(Code::kScan);
constexpr std::uint8_t kMean = ReplyTo(Code::kMean);
constexpr std::uint8_t kSubrange = ReplyTo(Code::kSubrange);
constexpr std::uint8_t kMeanSubrange = ReplyTo(Code::kMeanSubrange);
constexpr std::uint8_t kWithReflectivity = ReplyTo(Code::kReflectivity);

bool HasSamples(std::uint8_t code) { return code == kMean || code == kMeanSubrange; }
bool HasSubrange(std::uint8_t code) { return code == kSubrange || code == kMeanSubrange; }

std::uint16_t HeadOf(const MeasuredValues& values) {
  std::uint32_t head = static_cast<std::uint32_t>(values.words.size()) & kCountMask;
  head |= static_cast<std::uint32_t>(values.offset & 3) << kOffsetShift;
  if (values.partial) head |= kPartialBit;
  head |= static_cast<std::uint32_t>(values.unit) << kUnitShift;
  return static_cast<std::uint16_t>(head);
}

/// Fills in what the head says and returns the count.
std::size_t ReadHead(WireReader& reader, MeasuredValues& values) {
  std::uint16_t head = 0;
  reader.Word(head);
  const int unit = head >> kUnitShift;
  if (unit > 1) Fail("measured values of the LMS-200 are in cm (0) or mm (1), not in unit {}", unit);
  values.unit = static_cast<LengthUnit>(unit);
  values.partial = (head & kPartialBit) != 0;
  values.offset = head >> kOffsetShift & 3;
  return head & kCountMask;
}

/// A whole sweep has 181, 361 (180 deg) or 101, 201, 401 values (100 deg). A partial one has a value for
/// each degree, and one less if it is offset.
void CheckCount(std::size_t count, const MeasuredValues& values) {
  constexpr std::array<std::size_t, 5> kWhole{101, 181, 201, 361, 401};
  const std::size_t less = values.offset == 0 ? 0 : 1;
  const bool right = values.partial ? count == 101 - less || count == 181 - less
                                    : std::find(kWhole.begin(), kWhole.end(), count) != kWhole.end();
  if (!right) Fail("a sweep of the LMS-200 cannot have {} values", count);
}

void CheckSubrange(std::size_t count, const MeasuredValues& values) {
  if (values.first < 1 || values.last < values.first || values.last > 401) {
    Fail("the LMS-200 has no beams {} to {}", values.first, values.last);
  }
  const std::size_t beams = std::size_t{values.last} - values.first + 1;
  if (count != beams) {
    Fail("beams {} to {} are {} values, not {}", values.first, values.last, beams, count);
  }
}

void ReadWords(WireReader& reader, std::size_t count, MeasuredValues& values) {
  if (reader.size() < 2 * count) Fail("{} values do not fit in {} bytes", count, reader.size());
  values.words.resize(count);
  for (std::uint16_t& word : values.words) reader.Word(word);
}

void ReadReflectivity(WireReader& reader, MeasuredValues& values) {
  std::uint16_t count = 0;
  reader.Word(count);
  reader.Word(values.first);
  reader.Word(values.last);
  CheckSubrange(count, values);
  if (values.last > values.words.size()) Fail("beam {} has a reflectivity but no distance", values.last);
  if (reader.size() < count) Fail("{} reflectivities do not fit in {} bytes", count, reader.size());
  values.reflectivity.resize(count);
  for (std::uint8_t& byte : values.reflectivity) reader.Byte(byte);
}

}  // namespace

bool IsMeasuredValues(std::uint8_t code) {
  return code == kAll || code == kMean || code == kSubrange || code == kMeanSubrange ||
         code == kWithReflectivity;
}

Bytes EncodeMeasuredValues(const MeasuredValues& values) {
  WireWriter writer;
  writer.Byte(values.code);
  if (HasSamples(values.code)) writer.Byte(values.samples);
  if (HasSubrange(values.code)) {
    writer.Word(values.first);
    writer.Word(values.last);
  }
  writer.Word(HeadOf(values));
  for (const std::uint16_t word : values.words) writer.Word(word);
  if (values.code == kWithReflectivity) {
    writer.Word(static_cast<std::uint16_t>(values.reflectivity.size()));
    writer.Word(values.first);
    writer.Word(values.last);
    writer.Rest(values.reflectivity);
  }
  if (values.indices) {
    writer.Byte(values.indices->scan);
    writer.Byte(values.indices->telegram);
  }
  writer.Byte(values.status);
  Bytes payload = writer.Finish();
  if (payload.size() > kMaxPayload)
    Fail("{} measured values do not fit in a telegram", values.words.size());
  return payload;
}

MeasuredValues DecodeMeasuredValues(ByteView payload) {
  WireReader reader(payload);
  MeasuredValues values;
  reader.Byte(values.code);
  if (!IsMeasuredValues(values.code)) Fail("reply 0x{:02X} carries no measured values", values.code);
  if (HasSamples(values.code)) reader.Byte(values.samples);
  if (HasSubrange(values.code)) {
    reader.Word(values.first);
    reader.Word(values.last);
  }
  const std::size_t count = ReadHead(reader, values);
  HasSubrange(values.code) ? CheckSubrange(count, values) : CheckCount(count, values);
  ReadWords(reader, count, values);
  if (values.code == kWithReflectivity) ReadReflectivity(reader, values);
  if (reader.size() == 3) {
    values.indices.emplace();
    reader.Byte(values.indices->scan);
    reader.Byte(values.indices->telegram);
  }
  reader.Byte(values.status);
  reader.Finish();
  return values;
}

std::string_view NameOf(ValueError error) {
  constexpr std::array<std::string_view, 8> kNames{"none",
                                                   "not valid",
                                                   "dazzled",
                                                   "operation overflow",
                                                   "signal too weak",
                                                   "channel read error",
                                                   "above the maximum",
                                                   "unnamed"};
  return kNames[static_cast<std::size_t>(error)];
}

int DistanceBits(MeasuringMode mode) {
  switch (mode) {
    case MeasuringMode::k16mReflector:
    case MeasuringMode::k16mFieldsAb:
      return 14;
    case MeasuringMode::k32mReflector:
    case MeasuringMode::k32mFieldA:
    case MeasuringMode::k32m:
      return 15;
    case MeasuringMode::kReflectivity:  // the spec does not say; all of the word, as nothing else is in it
      return 16;
    default:
      return 13;
  }
}

Echo EchoOf(std::uint16_t word, MeasuringMode mode) {
  const int bits = DistanceBits(mode);
  const std::uint32_t largest = (1U << bits) - 1;
  Echo echo;
  echo.number = static_cast<std::uint16_t>(word & largest);
  echo.flags = static_cast<std::uint8_t>(static_cast<std::uint32_t>(word) >> bits);
  if (mode == MeasuringMode::kReflectivity) return echo;
  // Errors are the nine largest numbers, by their distance from the largest one.
  constexpr std::array<ValueError, 9> kErrors{
      ValueError::kNotValid, ValueError::kDazzled,    ValueError::kOverflow,
      ValueError::kUnnamed,  ValueError::kWeakSignal, ValueError::kChannel,
      ValueError::kUnnamed,  ValueError::kUnnamed,    ValueError::kTooFar};
  const std::uint32_t below = largest - echo.number;
  if (below < kErrors.size()) echo.error = kErrors[below];
  return echo;
}

int ReflectorLevels(MeasuringMode mode) {
  if (mode == MeasuringMode::k8mReflector) return 7;
  if (mode == MeasuringMode::k16mReflector) return 3;
  return mode == MeasuringMode::k32mReflector ? 1 : 0;
}

}  // namespace ariadne::drivers::lms200
