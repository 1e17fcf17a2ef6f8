#include "drivers/hardware/recorded_stream.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "drivers/hardware/memory_line.h"
#include "drivers/hardware/recorded_lines.h"
#include "tests/support/error_of.h"

namespace ariadne::drivers {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// A line that answers each byte with its successor, a little later.
class Successor : public ByteStream {
 public:
  std::string name() const override { return "successor"; }
  double Now() const override { return now_; }
  int baud() const override { return baud_; }
  Bytes Read(double deadline) override {
    now_ = answer_.empty() ? deadline : now_ + 0.125;
    return std::exchange(answer_, {});
  }
  void Write(ByteView bytes) override {
    for (const std::uint8_t byte : bytes) answer_.push_back(static_cast<std::uint8_t>(byte + 1));
    now_ += 0.25;
  }
  void SetBaud(int baud) override { baud_ = baud; }

 private:
  double now_ = 3.0;
  int baud_ = 9600;
  Bytes answer_;
};

/// What somebody does over a line, and all that it sees of it.
std::vector<double> Converse(ByteStream& line, std::uint8_t first) {
  std::vector<double> seen = {line.Now()};
  line.SetBaud(38400);
  line.Write(Bytes{first, 20});
  for (int i = 0; i < 2; ++i) {
    for (const std::uint8_t byte : line.Read(line.Now() + 1.0)) seen.push_back(byte);
    seen.push_back(line.Now());
  }
  seen.push_back(line.baud());
  return seen;
}

class Recorded : public testing::Test {
 protected:
  Recorded() {
    RecordingStream line(std::make_unique<Successor>(),
                         [this](const LineRecord& record) { records_.push_back(record); });
    live_ = Converse(line, 10);
  }

  std::vector<LineRecord> records_;
  std::vector<double> live_;
};

TEST_F(Recorded, AnswersAsTheLineDid) {
  ASSERT_EQ(records_.size(), 5U);
  EXPECT_EQ(live_, (std::vector<double>{3.0, 11, 21, 3.375, 4.375, 38400}));
  RecordedLines lines = OneRecordedLine(records_);
  const auto again = lines.Open(0);
  EXPECT_EQ(Converse(*again, 10), live_);
  EXPECT_EQ(again->name(), "successor");
  lines.ExpectEnd();
  EXPECT_EQ(lines.departure(), "");
  EXPECT_EQ(lines.repeated(), 5U);
  EXPECT_EQ(lines.time(), 4.375);
}

/// Drivers survive single errors, so that a departure must go on.
TEST_F(Recorded, FailsFromWhereTheCallerDoesSomethingElse) {
  RecordedLines lines = OneRecordedLine(records_);
  const auto other_bytes = lines.Open(0);
  EXPECT_THAT(
      ErrorOf([&] { Converse(*other_bytes, 11); }),
      AllOf(HasSubstr("call 3 to the lines (3.250 s) was recorded as successor being written 0A 14"),
            HasSubstr("now successor is written 0B 14")));
  EXPECT_THAT(ErrorOf([&] { other_bytes->Read(9.0); }), HasSubstr("call 3"));
  EXPECT_THAT(lines.departure(), HasSubstr("call 3"));
}

TEST_F(Recorded, FailsForOtherKindsOfCalls) {
  RecordedLines call = OneRecordedLine(records_), rate = OneRecordedLine(records_);
  EXPECT_THAT(ErrorOf([&] { call.Open(0)->Read(9.0); }), HasSubstr("being set to 38400 baud; now"));
  EXPECT_THAT(ErrorOf([&] { rate.Open(0)->SetBaud(9600); }), HasSubstr("is set to 9600 baud"));
  RecordedLines headless = OneRecordedLine({records_[1]});
  EXPECT_THROW(headless.Open(0), Error);
}

TEST_F(Recorded, TellsTheEndFromADeparture) {
  RecordedLines longer = OneRecordedLine(records_);
  const auto line = longer.Open(0);
  Converse(*line, 10);
  EXPECT_THROW(line->Read(99.0), LinesEnded);
  EXPECT_THROW(line->Read(99.0), LinesEnded);
  EXPECT_EQ(longer.departure(), "");
  RecordedLines shorter = OneRecordedLine(records_);
  shorter.Open(0)->SetBaud(38400);
  shorter.ExpectEnd();
  EXPECT_THAT(shorter.departure(), HasSubstr("no line is used any more"));
  RecordedLines none = OneRecordedLine({});
  EXPECT_THROW(none.Open(0), LinesEnded);
}

/// The order of the calls is one over all lines; notes are no calls.
TEST_F(Recorded, HasOneOrderOverAllLines) {
  std::vector<LoggedRecord> log;
  for (const LineRecord& record : records_) {
    log.push_back({0, record});
    log.push_back({255, {LineRecord::Kind::kNote, 0.0, {'n'}}});
    log.push_back({1, record});
  }
  const auto replay = [&log] {
    return RecordedLines("two lines", [&log, next = std::size_t{0}]() mutable {
      return next < log.size() ? std::optional<LoggedRecord>(log[next++]) : std::nullopt;
    });
  };
  RecordedLines in_order = replay();
  const auto a = in_order.Open(0), b = in_order.Open(1);
  a->SetBaud(38400);
  b->SetBaud(38400);
  EXPECT_EQ(in_order.repeated(), 4U);
  RecordedLines other_order = replay();
  const auto c = other_order.Open(0), d = other_order.Open(1);
  EXPECT_THROW(d->SetBaud(38400), Error);
  EXPECT_THAT(other_order.departure(), HasSubstr("call 3 to the lines"));
}

/// A line that is gone is an answer too.
TEST(RecordedError, IsThrownOnceMore) {
  MemoryLine line;
  struct Unowned : ByteStream {  // the memory line keeps its ends
    explicit Unowned(ByteStream& end) : end(end) {}
    std::string name() const override { return end.name(); }
    double Now() const override { return end.Now(); }
    Bytes Read(double deadline) override { return end.Read(deadline); }
    void Write(ByteView bytes) override { end.Write(bytes); }
    void SetBaud(int baud) override { end.SetBaud(baud); }
    int baud() const override { return end.baud(); }
    ByteStream& end;
  };
  std::vector<LineRecord> records;
  RecordingStream recording(std::make_unique<Unowned>(line.end(0)),
                            [&records](const LineRecord& record) { records.push_back(record); });
  recording.Read(1.0);
  line.Cut();
  const std::string error = ErrorOf([&] { recording.Read(2.0); });
  EXPECT_THAT(error, HasSubstr("was cut"));
  RecordedLines lines = OneRecordedLine(records);
  const auto again = lines.Open(0);
  again->Read(1.0);
  EXPECT_EQ(ErrorOf([&] { again->Read(2.0); }), error);
  EXPECT_EQ(lines.departure(), "");
}

}  // namespace
}  // namespace ariadne::drivers
