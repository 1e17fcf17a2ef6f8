#include "drivers/hardware/lms200/values.h"

#include <gtest/gtest.h>

#include "slam/base/error.h"
#include "tests/drivers/hardware/lms200/samples.h"

namespace ariadne::drivers::lms200 {
namespace {

/// A head word, so many zeros, and a status byte.
Bytes Payload(std::uint16_t head, std::size_t count, std::size_t extra = 0) {
  Bytes payload = {0xB0, static_cast<std::uint8_t>(head & 0xFF), static_cast<std::uint8_t>(head >> 8)};
  payload.resize(payload.size() + 2 * count + extra);
  payload.push_back(0x10);
  return payload;
}

TEST(Lms200Values, HaveTheHeadOfTheSpec) {
  const MeasuredValues whole = DecodeMeasuredValues(Payload(0x4000 | 361, 361));
  EXPECT_EQ(whole.words.size(), 361U);
  EXPECT_EQ(whole.unit, LengthUnit::kMillimetre);
  EXPECT_FALSE(whole.partial);
  EXPECT_FALSE(whole.indices);
  const MeasuredValues partial = DecodeMeasuredValues(Payload(0x2000 | 3 << 11 | 180, 180, 2));
  EXPECT_EQ(partial.unit, LengthUnit::kCentimetre);
  EXPECT_TRUE(partial.partial);
  EXPECT_EQ(partial.offset, 3);
  EXPECT_TRUE(partial.indices);
}

TEST(Lms200Values, HaveTheCountsOfTheSpec) {
  for (const std::uint16_t count : {101, 181, 201, 361, 401}) {
    EXPECT_NO_THROW(DecodeMeasuredValues(Payload(count, count))) << count;
  }
  for (const std::uint16_t count : {0, 1, 100, 180, 182, 360, 400, 402}) {
    EXPECT_THROW(DecodeMeasuredValues(Payload(count, count)), Error) << count;
  }
  for (int offset = 0; offset < 4; ++offset) {
    for (const int count : {100, 101, 180, 181, 361}) {
      const auto head = static_cast<std::uint16_t>(0x2000 | offset << 11 | count);
      const Bytes payload = Payload(head, static_cast<std::size_t>(count));
      if (count == (offset == 0 ? 101 : 100) || count == (offset == 0 ? 181 : 180)) {
        EXPECT_NO_THROW(DecodeMeasuredValues(payload)) << offset << " " << count;
      } else {
        EXPECT_THROW(DecodeMeasuredValues(payload), Error) << offset << " " << count;
      }
    }
  }
}

TEST(Lms200Values, AreRefusedWhenTheLengthIsWrong) {
  for (const std::size_t extra : {1U, 3U, 4U}) {
    EXPECT_THROW(DecodeMeasuredValues(Payload(181, 181, extra)), Error);
  }
  EXPECT_THROW(DecodeMeasuredValues(Payload(181, 180)), Error);
  EXPECT_THROW(DecodeMeasuredValues(Payload(361, 181)), Error);
  EXPECT_THROW(DecodeMeasuredValues(Payload(0x8000 | 181, 181)), Error);  // units 2 and 3
  EXPECT_THROW(DecodeMeasuredValues(Payload(0xC000 | 181, 181)), Error);
}

TEST(Lms200Values, AreReadAsTheyWereWritten) {
  RandomStream stream = NamedStream(1, "values");
  for (int round = 0; round < 300; ++round) {
    const MeasuredValues values = AnyValues(stream);
    EXPECT_EQ(DecodeMeasuredValues(EncodeMeasuredValues(values)), values);
  }
}

TEST(Lms200Values, MustFitInATelegram) {
  MeasuredValues values;
  values.code = 0xC4;
  values.words.resize(361);
  values.reflectivity.resize(361);
  values.first = 1;
  values.last = 361;
  EXPECT_THROW(EncodeMeasuredValues(values), Error);
}

TEST(Lms200Values, OfASubrangeMustBeAsManyAsItsBeams) {
  MeasuredValues values;
  values.code = 0xB7;
  values.first = 10;
  values.last = 20;
  values.words.resize(11);
  Bytes payload = EncodeMeasuredValues(values);
  EXPECT_EQ(DecodeMeasuredValues(payload), values);
  payload[3] = 21;
  EXPECT_THROW(DecodeMeasuredValues(payload), Error);
  payload[3] = 9;
  EXPECT_THROW(DecodeMeasuredValues(payload), Error);
}

struct WordCase {
  MeasuringMode mode;
  std::uint16_t word;
  int number;
  int flags;
  ValueError error;
};

TEST(Lms200Echo, HasDistanceAndFlagsOfItsMode) {
  using M = MeasuringMode;
  constexpr ValueError kNone = ValueError::kNone;
  const std::vector<WordCase> cases = {{M::k8mFieldsAbDazzle, 0x2000 | 1234, 1234, 1, kNone},
                                       {M::k8mFieldsAbDazzle, 0x8000 | 0x1FF6, 0x1FF6, 4, kNone},
                                       {M::k8mReflector, 0xE000 | 5, 5, 7, kNone},
                                       {M::k8mFieldsAbc, 0x6000, 0, 3, kNone},
                                       {M::k16mReflector, 0xC000 | 0x1FFF, 0x1FFF, 3, kNone},
                                       {M::k16mFieldsAb, 0x4000 | 0x3FF6, 0x3FF6, 1, kNone},
                                       {M::k32mReflector, 0x8000 | 0x3FFF, 0x3FFF, 1, kNone},
                                       {M::k32mFieldA, 0x7FF6, 0x7FF6, 0, kNone},
                                       {M::k32m, 0x7000, 0x7000, 0, kNone},
                                       {M::kReflectivity, 0x1FFF, 0x1FFF, 0, kNone}};
  for (const WordCase& expected : cases) {
    const Echo echo = EchoOf(expected.word, expected.mode);
    EXPECT_EQ(echo.number, expected.number);
    EXPECT_EQ(echo.flags, expected.flags);
    EXPECT_EQ(echo.error, expected.error);
  }
}

/// Spec 9.3: values from 1FF7 on are no distances, also with flags, and alike in the longer modes.
TEST(Lms200Echo, NamesEachError) {
  using E = ValueError;
  const std::vector<std::pair<int, E>> named = {
      {0xFFFF, E::kNotValid},   {0xFFFE, E::kDazzled}, {0xFFFD, E::kOverflow}, {0xFFFC, E::kUnnamed},
      {0xFFFB, E::kWeakSignal}, {0xFFFA, E::kChannel}, {0xFFF9, E::kUnnamed},  {0xFFF8, E::kUnnamed},
      {0xFFF7, E::kTooFar},     {0xFFF6, E::kNone}};
  const std::vector<std::pair<MeasuringMode, int>> masks = {{MeasuringMode::k8mReflector, 0x1FFF},
                                                            {MeasuringMode::k16mFieldsAb, 0x3FFF},
                                                            {MeasuringMode::k32m, 0x7FFF}};
  for (const auto& [mode, mask] : masks) {
    for (const auto& [word, error] : named) {
      EXPECT_EQ(EchoOf(static_cast<std::uint16_t>(word), mode).error, error) << word;
      EXPECT_EQ(EchoOf(static_cast<std::uint16_t>(word & mask), mode).error, error) << word;
    }
  }
}

}  // namespace
}  // namespace ariadne::drivers::lms200
