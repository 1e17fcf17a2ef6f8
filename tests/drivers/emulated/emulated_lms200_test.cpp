// The emulated scanner as a client would meet it that knows nothing of this program: bytes there and back.
#include "drivers/emulated/emulated_lms200.h"

#include <gtest/gtest.h>

#include "drivers/emulated/emulated_line.h"
#include "tests/drivers/hardware/lms200/samples.h"

namespace ariadne::drivers {
namespace {

using lms200::Code;
using lms200::Command;
using lms200::CommandOf;
using lms200::DrawBytes;
using lms200::FrameOf;
using lms200::FromHex;
using lms200::Mode;
using lms200::ModeCommand;
using lms200::Reply;

slam::LaserSweep Wall(double, const slam::ScannerModel&, std::size_t beams) {
  slam::LaserSweep sweep;
  for (std::size_t i = 0; i < beams; ++i) sweep.ranges.push_back(static_cast<float>(i) * 0.1F);
  return sweep;
}

class EmulatedLms200Test : public testing::Test {
 protected:
  void Start(const EmulatedLms200Options& options = {}) {
    device_ = std::make_unique<EmulatedLms200>(options, Wall);
    line_ = std::make_unique<EmulatedLine>(*device_);
    boot_ = ReadFor(options.boot_time + 0.1);
  }

  Bytes ReadFor(double seconds) {
    const double end = line_->Now() + seconds;
    Bytes all;
    while (line_->Now() < end) {
      for (const std::uint8_t byte : line_->Read(end)) all.push_back(byte);
    }
    return all;
  }
  Bytes Ask(const Bytes& request, double seconds = 0.5) {
    line_->Write(request);
    return ReadFor(seconds);
  }
  static Bytes Acknowledged(const Reply& reply) {
    Bytes bytes = {0x06};
    for (const std::uint8_t byte : FrameOf(reply)) bytes.push_back(byte);
    return bytes;
  }
  Bytes AskMode(Mode mode) { return Ask(FrameOf(ModeCommand(mode))); }
  static Bytes ModeOk() { return FromHex("06 02 80 03 00 A0 00 10 16 0A"); }

  std::unique_ptr<EmulatedLms200> device_;
  std::unique_ptr<EmulatedLine> line_;
  Bytes boot_;
};

TEST_F(EmulatedLms200Test, SendsItsPowerOnStringAt9600Baud) {
  Start();
  EXPECT_EQ(boot_, FrameOf(Reply(lms200::PowerOn{"LMS200;30106x;V02.10"})));
}

TEST_F(EmulatedLms200Test, AnswersAStatusRequestFirst) {
  Start();
  const Bytes answer = Ask(FromHex("02 00 01 00 31 15 12"));
  ASSERT_EQ(answer.size(), 161U);
  EXPECT_EQ(answer[0], 0x06);
  EXPECT_EQ(answer[1], 0x02);
  EXPECT_EQ(answer[2], 0x80);
  EXPECT_EQ(answer[5], 0xB1);
  const lms200::StatusReply status = lms200::DecodeStatus(ByteView(answer).subspan(5, 154));
  EXPECT_EQ(status.baud, 9600);
  EXPECT_EQ(status.mode, Mode::kOnRequest);
}

TEST_F(EmulatedLms200Test, AcknowledgesWithin60Milliseconds) {
  Start();
  line_->Write(FromHex("02 00 01 00 3A 1E 12"));
  const double sent = line_->Now() + 7 * 10.0 / 9600;
  EXPECT_EQ(line_->Read(sent + 0.06).front(), 0x06);
}

TEST_F(EmulatedLms200Test, IsFoundByTryingRates) {
  Start();
  EXPECT_EQ(Ask(FromHex("02 00 02 00 20 40 50 08")), ModeOk());
  for (const int baud : {9600, 19200, 500000}) {
    line_->SetBaud(baud);
    EXPECT_NE(Ask(FromHex("02 00 01 00 31 15 12")).size(), 161U) << baud;
  }
  line_->SetBaud(38400);
  EXPECT_EQ(Ask(FromHex("02 00 01 00 31 15 12")).size(), 161U);
}

TEST_F(EmulatedLms200Test, AnswersAChangeOfItsRateAtTheNewOneIfToldSo) {
  EmulatedLms200Options options;
  options.reply_at_new_baud = true;
  Start(options);
  line_->Write(FromHex("02 00 02 00 20 40 50 08"));
  EXPECT_EQ(ReadFor(0.02), Bytes{0x06});
  line_->SetBaud(38400);
  EXPECT_EQ(ReadFor(0.5), FromHex("02 80 03 00 A0 00 10 16 0A"));
}

TEST_F(EmulatedLms200Test, LosesItsRateWithItsPowerUnlessItIsPermanent) {
  Start();
  AskMode(Mode::kBaud38400);
  line_->SetBaud(38400);
  device_->LosePower(line_->Now(), 0.1);
  ReadFor(3.0);
  EXPECT_EQ(device_->baud(), 9600);
  line_->SetBaud(9600);
  AskMode(Mode::kBaud38400);
  line_->SetBaud(38400);
  Command permanent = CommandOf(Code::kPermanentBaud);
  permanent.permanent = true;
  EXPECT_EQ(Ask(FrameOf(permanent)), Acknowledged(lms200::PermanentBaudReply{true}));
  device_->LosePower(line_->Now(), 0.1);
  EXPECT_EQ(ReadFor(3.0), FrameOf(Reply(lms200::PowerOn{"LMS200;30106x;V02.10"})));
}

TEST_F(EmulatedLms200Test, ConfirmsAResetAndBoots) {
  Start();
  AskMode(Mode::kBaud38400);
  line_->SetBaud(38400);
  EXPECT_EQ(Ask(FromHex("02 00 01 00 10 34 12")), Acknowledged(lms200::Notice{lms200::kResetConfirmed}));
  EXPECT_TRUE(Ask(FromHex("02 00 01 00 31 15 12")).empty());  // while it boots
  line_->SetBaud(9600);
  EXPECT_EQ(ReadFor(3.0), FrameOf(Reply(lms200::PowerOn{"LMS200;30106x;V02.10"})));
}

TEST_F(EmulatedLms200Test, RefusesWrongChecksumsAndUnknownCommands) {
  Start();
  EXPECT_EQ(Ask(FromHex("02 00 01 00 31 15 13")), Bytes{0x15});
  EXPECT_EQ(Ask(lms200::EncodeTelegram({0, {0x55, 1, 2}})),
            Acknowledged(lms200::Notice{lms200::kUnknownCommand}));
  EXPECT_EQ(Ask(lms200::EncodeTelegram({0, {0x3B, 180}})), Bytes{0x15});
  EXPECT_TRUE(Ask(lms200::EncodeTelegram({5, {0x31}})).empty());  // to another device on a bus
  EXPECT_EQ(Ask(FromHex("02 00 01 00 31 15 12")).size(), 161U);
}

TEST_F(EmulatedLms200Test, ForgetsHalfATelegramAfterAPause) {
  Start();
  EXPECT_TRUE(Ask(FromHex("02 00 0A 00 20 00 53"), 0.05).empty());
  EXPECT_EQ(Ask(FromHex("02 00 01 00 3A 1E 12")), Acknowledged(lms200::TypeReply{"LMS200;30106x;V02.10"}));
  line_->Write(FromHex("02 00 01 00"));  // within a pause of 14 ms, both halves are one
  ReadFor(0.01);
  EXPECT_EQ(Ask(FromHex("3A 1E 12")), Acknowledged(lms200::TypeReply{"LMS200;30106x;V02.10"}));
}

TEST_F(EmulatedLms200Test, SurvivesAnything) {
  Start();
  RandomStream stream = NamedStream(1, "anything");
  for (int i = 0; i < 300; ++i) Ask(DrawBytes(stream, 1 + stream() % 40), 0.06);
  ReadFor(0.1);
  EXPECT_EQ(Ask(FromHex("02 00 01 00 31 15 12")).size(), 161U);
}

TEST_F(EmulatedLms200Test, WritesItsConfigurationWithThePasswordOnly) {
  Start();
  const lms200::Config wanted = lms200::WithUnit(device_->config(), lms200::LengthUnit::kMillimetre);
  Command write = CommandOf(Code::kWriteConfig);
  write.data = wanted.bytes;
  EXPECT_EQ(Ask(FrameOf(write)), Acknowledged(lms200::WrittenReply{false, device_->config()}));
  EXPECT_EQ(Ask(FrameOf(lms200::PasswordCommand("SICK_LMX"))),
            Acknowledged(lms200::ModeReply{lms200::ModeAnswer::kRefused}));
  EXPECT_EQ(Ask(FromHex("02 00 0A 00 20 00 53 49 43 4B 5F 4C 4D 53 BE C5")), ModeOk());
  EXPECT_EQ(Ask(FrameOf(write)), Acknowledged(lms200::WrittenReply{true, wanted}));
  device_->LosePower(line_->Now(), 0.1);
  ReadFor(3.0);
  EXPECT_EQ(Ask(FromHex("02 00 01 00 74 50 12")), Acknowledged(lms200::ConfigReply{wanted}));
}

TEST_F(EmulatedLms200Test, IsLenientIfToldSo) {
  EmulatedLms200Options options;
  options.strict = false;
  Start(options);
  Command write = CommandOf(Code::kWriteConfig);
  write.data = lms200::WithUnit(device_->config(), lms200::LengthUnit::kMillimetre).bytes;
  EXPECT_EQ(Ask(FrameOf(write)), Acknowledged(lms200::WrittenReply{true, {write.data}}));
  AskMode(Mode::kDiagnostic);
  EXPECT_EQ(Ask(FrameOf(lms200::VariantCommand({180, 100}))),
            Acknowledged(lms200::VariantReply{true, 180, 100}));
  EXPECT_EQ(Ask(lms200::EncodeTelegram({5, {0x3A}})).front(), 0x06);
  EXPECT_GT(Ask(FrameOf(CommandOf(Code::kScan))).size(), 372U);  // in any mode
}

TEST_F(EmulatedLms200Test, HasTheVariantsOfTheSpec) {
  Start();
  EXPECT_EQ(Ask(FromHex("02 00 05 00 3B 64 00 19 00 E7 72")),
            Acknowledged(lms200::VariantReply{true, 100, 25}));
  EXPECT_EQ(Ask(FrameOf(lms200::VariantCommand({180, 25}))),
            Acknowledged(lms200::VariantReply{false, 100, 25}));
  AskMode(Mode::kDiagnostic);
  EXPECT_EQ(Ask(FrameOf(lms200::VariantCommand({180, 50}))),
            Acknowledged(lms200::VariantReply{false, 100, 25}));
}

lms200::MeasuredValues ValuesIn(const Bytes& answer) {
  return lms200::DecodeMeasuredValues(ByteView(answer).subspan(5, answer.size() - 7));
}

TEST_F(EmulatedLms200Test, MeasuresOnRequest) {
  Start();
  Ask(FrameOf(lms200::VariantCommand({180, 100})));
  const Bytes answer = Ask(FromHex("02 00 02 00 30 01 31 18"));
  ASSERT_EQ(answer.size(), 373U);
  const lms200::MeasuredValues values = ValuesIn(answer);
  EXPECT_EQ(values.words[10], 100);  // 1 m in cm
  EXPECT_EQ(values.words[180], 1800);
  EXPECT_TRUE(ReadFor(0.5).empty());  // one only
  const lms200::MeasuredValues part = ValuesIn(Ask(lms200::EncodeTelegram({0, FromHex("37 0B 00 14 00")})));
  EXPECT_EQ(part.words.size(), 10U);
  EXPECT_EQ(part.words[0], 100);
  const lms200::MeasuredValues mean = ValuesIn(Ask(lms200::EncodeTelegram({0, FromHex("36 05")})));
  EXPECT_EQ(mean.samples, 5);
  EXPECT_EQ(mean.words[10], 100);
  EXPECT_EQ(Ask(lms200::EncodeTelegram({0, FromHex("37 0B 00 B6 00")})),
            Bytes{0x15});  // there is no beam 182
  EXPECT_EQ(Ask(lms200::EncodeTelegram({0, FromHex("44 01 00 B5 00")})),
            Acknowledged(lms200::Notice{lms200::kUnknownCommand}));
}

TEST_F(EmulatedLms200Test, SaysWhereThereIsNoDistance) {
  Start();
  Ask(FrameOf(lms200::VariantCommand({180, 50})));
  Command write = CommandOf(Code::kWriteConfig);
  write.data = lms200::WithUnit(device_->config(), lms200::LengthUnit::kMillimetre).bytes;
  Ask(FrameOf(lms200::PasswordCommand()));
  Ask(FrameOf(write));
  AskMode(Mode::kOnRequest);
  const lms200::MeasuredValues values = ValuesIn(Ask(FromHex("02 00 02 00 30 01 31 18"), 1.0));
  EXPECT_EQ(values.words[81], 8100);
  EXPECT_EQ(values.words[82], 0x1FF7);  // 8.2 m are too far in mm
  EXPECT_EQ(values.words[360], 0x1FF7);
}

TEST_F(EmulatedLms200Test, AnswersWhileItStreams) {
  Start();
  AskMode(Mode::kBaud500000);
  line_->SetBaud(500000);
  lms200::TelegramDecoder decoder(lms200::Sender::kDevice);
  decoder.Push(AskMode(Mode::kStream));
  decoder.Push(Ask(FromHex("02 00 01 00 3A 1E 12")));
  int sweeps = 0;
  int types = 0;
  while (const auto received = decoder.Next()) {
    if (received->kind != lms200::Received::Kind::kTelegram) continue;
    if (received->telegram.payload.front() == 0xB0) ++sweeps;
    if (received->telegram.payload.front() == 0xBA) ++types;
  }
  EXPECT_EQ(types, 1);
  EXPECT_GE(sweeps, 33);  // in a second less 50 ms
  EXPECT_EQ(decoder.garbage(), 0U);
  EXPECT_EQ(device_->mode(), Mode::kStream);
}

/// Spec 9.3: at 38400 baud at most 10.3 and 5.2 telegrams/s fit; measured were 4.7 of 361 values.
TEST_F(EmulatedLms200Test, StreamsAtTheSpeedOfTheLine) {
  const std::vector<std::tuple<Mode, int, std::uint16_t, double>> cases = {
      {Mode::kBaud38400, 38400, 50, 4.69},   // every 8th turn of 2
      {Mode::kBaud38400, 38400, 100, 9.38},  // every 8th turn
      {Mode::kBaud500000, 500000, 100, 75.0},
      {Mode::kBaud500000, 500000, 50, 37.5}};
  for (const auto& [mode, baud, resolution, per_second] : cases) {
    Start();
    AskMode(mode);
    line_->SetBaud(baud);
    Ask(FrameOf(lms200::VariantCommand({180, resolution})));
    AskMode(Mode::kStream);
    const double frame = 2.0 * (18000.0 / resolution + 1.0) + 10.0;
    const double measured = static_cast<double>(ReadFor(20.0).size()) / frame / 20.0;
    EXPECT_NEAR(measured, per_second, 0.05 * per_second) << baud << " " << resolution;
  }
}

TEST_F(EmulatedLms200Test, InterleavesPartialSweeps) {
  Start();
  AskMode(Mode::kBaud500000);
  line_->SetBaud(500000);
  lms200::TelegramDecoder decoder(lms200::Sender::kDevice);
  decoder.Push(Ask(FrameOf([] {
                     Command command = ModeCommand(Mode::kSomePartial);
                     command.data = {6};
                     return command;
                   }()),
                   1.0));
  std::vector<int> offsets;
  while (const auto received = decoder.Next()) {
    if (received->kind != lms200::Received::Kind::kTelegram || received->telegram.payload[0] != 0xB0)
      continue;
    const lms200::MeasuredValues values = lms200::DecodeMeasuredValues(received->telegram.payload);
    EXPECT_TRUE(values.partial);
    EXPECT_EQ(values.words.size(), values.offset == 0 ? 181U : 180U);
    offsets.push_back(values.offset);
  }
  ASSERT_EQ(offsets.size(), 6U);
  for (std::size_t i = 1; i < offsets.size(); ++i) EXPECT_EQ(offsets[i], (offsets[i - 1] + 1) % 4);
}

}  // namespace
}  // namespace ariadne::drivers
