#include "drivers/hardware/lms200/reply.h"

#include <gtest/gtest.h>

#include "slam/base/error.h"
#include "tests/drivers/hardware/lms200/samples.h"

namespace ariadne::drivers::lms200 {
namespace {

TEST(Lms200Reply, IsReadAsItWasWritten) {
  RandomStream stream = NamedStream(1, "replies");
  for (std::uint32_t round = 0; round < 40 * kReplyKinds; ++round) {
    const Reply reply = AnyReply(stream, round % kReplyKinds);
    EXPECT_EQ(DecodeReply(EncodeReply(reply)), reply) << "kind " << round % kReplyKinds;
  }
}

TEST(Lms200Reply, TravelsAsTheTableSays) {
  const std::vector<std::pair<Reply, const char*>> table = {
      {PowerOn{"LMS"}, "90 4C 4D 53 10"},
      {Notice{kResetConfirmed}, "91 10"},
      {Notice{kUnknownCommand}, "92 10"},
      {ModeReply{ModeAnswer::kRefused, 0x13}, "A0 01 13"},
      {ErrorReply{{{1, 2}, {3, 4}}, 0x90}, "B2 01 02 03 04 90"},
      {TypeReply{"L2"}, "BA 4C 32 10"},
      {VariantReply{true, 180, 50}, "BB 01 B4 00 32 00 10"},
      {PermanentBaudReply{false}, "E6 00 10"}};
  for (const auto& [reply, hex] : table) {
    EXPECT_EQ(EncodeReply(reply), FromHex(hex)) << hex;
    EXPECT_EQ(DecodeReply(FromHex(hex)), reply) << hex;
  }
}

TEST(Lms200Reply, IsRefusedWhenTheDeviceCannotMeanIt) {
  for (const char* hex : {"B1 10", "A0 10", "A0 03 10", "A0 00 00 10", "B2 01 10", "BB 01 B4 00 32 10",
                          "BB 02 B4 00 32 00 10", "E6 10", "E6 02 10", "F4 10", "91 00 10", "80 10",
                          "93 10", "B0 00 00 10", "C4 10"}) {
    EXPECT_THROW(DecodeReply(FromHex(hex)), Error) << hex;
  }
  EXPECT_THROW(DecodeReply({}), Error);
  EXPECT_THROW(DecodeReply(FromHex("91")), Error);
}

TEST(Lms200Config, Has34BytesOr32) {
  for (const std::size_t size : {kConfigSize, kOldConfigSize}) {
    const Config config = FactoryConfig(size);
    EXPECT_EQ(ConfigOf(config.bytes), config);
    EXPECT_EQ(std::get<ConfigReply>(DecodeReply(EncodeReply(ConfigReply{config}))).config, config);
  }
  for (const std::size_t size : {0U, 31U, 33U, 35U}) EXPECT_THROW(ConfigOf(Bytes(size)), Error);
}

TEST(Lms200Config, ChangesOneByteOnly) {
  RandomStream stream = NamedStream(3, "config");
  Bytes bytes = DrawBytes(stream, kConfigSize);
  bytes[5] = 0;
  bytes[6] = 0;
  const Config before = ConfigOf(bytes);
  const auto expect_only = [&](const Config& after, std::size_t at, std::uint8_t value) {
    Bytes wanted = before.bytes;
    wanted[at] = value;
    EXPECT_EQ(after.bytes, wanted);
  };
  expect_only(WithMeasuringMode(before, MeasuringMode::k32m), 5, 0x0F);
  expect_only(WithUnit(before, LengthUnit::kMillimetre), 6, 1);
  expect_only(WithRealTimeIndices(before, true), 4, static_cast<std::uint8_t>(bytes[4] | 2));
  expect_only(WithRealTimeIndices(before, false), 4, static_cast<std::uint8_t>(bytes[4] & ~2));
  bytes[6] = 2;
  EXPECT_THROW(ConfigOf(bytes), Error);
  bytes[6] = 0;
  bytes[5] = 7;
  EXPECT_THROW(ConfigOf(bytes), Error);
}

/// The places of spec 9.2, one by one.
TEST(Lms200Status, HasEachThingInItsPlace) {
  StatusReply status;
  status.software = "V02.10";
  status.mode = Mode::kStream;
  status.error = 3;
  status.type = 9;
  status.motor_revolutions = 0x1234;
  status.measuring_mode = MeasuringMode::k8mReflector;
  status.variant = {100, 25};
  status.baud = 500000;
  status.permanent_baud = true;
  status.address = 5;
  status.unit = LengthUnit::kMillimetre;
  status.boot_prom = "X01";
  const Bytes payload = EncodeStatus(status);
  ASSERT_EQ(payload.size(), 154U);
  EXPECT_EQ(payload[0], 0xB1);
  EXPECT_EQ(payload[1], 'V');
  EXPECT_EQ(payload[8], 0x24);
  EXPECT_EQ(payload[9], 3);
  EXPECT_EQ(payload[18], 9);
  EXPECT_EQ(payload[67] | payload[68] << 8, 0x1234);
  EXPECT_EQ(payload[102], 1);
  EXPECT_EQ(payload[107], 100);
  EXPECT_EQ(payload[109], 25);
  EXPECT_EQ(payload[116] | payload[117] << 8, 0x8001);
  EXPECT_EQ(payload[119], 1);
  EXPECT_EQ(payload[120], 5);
  EXPECT_EQ(payload[122], 1);
  EXPECT_EQ(payload[123], 1);
  EXPECT_EQ(payload[124], 'X');
}

TEST(Lms200Status, NamesRatesByTheirDivisor) {
  const std::vector<std::pair<int, int>> words = {
      {9600, 0x8067}, {19200, 0x8033}, {38400, 0x8019}, {500000, 0x8001}};
  for (const auto& [baud, word] : words) {
    StatusReply status;
    status.baud = baud;
    const Bytes payload = EncodeStatus(status);
    EXPECT_EQ(payload[116] | payload[117] << 8, word);
    EXPECT_EQ(DecodeStatus(payload).baud, baud);
  }
}

TEST(Lms200Status, IsRefusedWhenItCannotBe) {
  const Bytes good = EncodeStatus({});
  for (const std::size_t at : {0U, 102U, 107U, 109U, 116U, 122U}) {
    Bytes bad = good;
    bad[at] = 0x77;
    EXPECT_THROW(DecodeStatus(bad), Error) << at;
  }
  EXPECT_THROW(DecodeStatus(ByteView(good).first(153)), Error);
}

TEST(Lms200DeviceStatus, HasTheBitsOfTheSpec) {
  EXPECT_EQ(DeviceStatusOf(0x10), DeviceStatus{});
  EXPECT_EQ(DeviceStatusOf(0x18), DeviceStatus{});
  EXPECT_EQ(DeviceStatusOf(0x92), (DeviceStatus{2, false, false, true}));
  EXPECT_EQ(DeviceStatusOf(0x64), (DeviceStatus{4, true, true, false}));
}

}  // namespace
}  // namespace ariadne::drivers::lms200
