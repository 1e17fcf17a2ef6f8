#include "drivers/hardware/recorded_stream.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "drivers/hardware/memory_line.h"
#include "slam/base/error.h"

namespace ariadne::drivers {
namespace {

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
  RecordedStream again(records_);
  EXPECT_EQ(Converse(again, 10), live_);
  EXPECT_EQ(again.left(), 0U);
  EXPECT_EQ(again.name(), "successor");
}

TEST_F(Recorded, FailsWhereTheCallerDoesSomethingElse) {
  RecordedStream other_bytes(records_);
  EXPECT_THROW(Converse(other_bytes, 11), Error);
  RecordedStream other_call(records_);
  EXPECT_THROW(other_call.Read(9.0), Error);
  RecordedStream other_rate(records_);
  EXPECT_THROW(other_rate.SetBaud(9600), Error);
  EXPECT_THROW(RecordedStream({}), Error);
  EXPECT_THROW(RecordedStream({records_[1]}), Error);
  RecordedStream longer(records_);
  Converse(longer, 10);
  EXPECT_THROW(longer.Read(99.0), Error);
}

}  // namespace
}  // namespace ariadne::drivers
