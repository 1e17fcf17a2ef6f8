#include "drivers/replay/robot_log.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "drivers/replay/call_bytes.h"
#include "drivers/replay/log_frame.h"
#include "slam/base/error.h"
#include "tests/drivers/replay/calls.h"
#include "tests/drivers/replay/full_disk.h"
#include "tests/slam/io/support.h"

namespace ariadne::drivers {
namespace {

namespace fs = std::filesystem;
using slam::testing_support::ContentOf;
using slam::testing_support::TemporaryFolder;
using testing::HasSubstr;

RobotLog LogOf(const std::string& bytes) {
  return {std::make_unique<std::istringstream>(bytes), "run/robot.log"};
}

std::vector<std::string> RecordsOf(RobotLog log) {
  std::vector<std::string> records;
  for (std::size_t i = 0; i < log.size(); ++i) records.push_back(EncodeCall(log.Read(i)));
  return records;
}

/// A log of a few short records of all kinds, and where each ends.
struct ShortLog {
  ShortLog() {
    RandomStream stream = NamedStream(7, "short");
    for (const int kind : {0, 1, 5, 2, 4, 6, 7, 3, 8, 6, 0}) {
      const RobotCall call = AnyCall(stream, static_cast<CallKind>(kind));
      records.push_back(EncodeCall(call));
      bytes += FramedCall(call);
      ends.push_back(bytes.size());
    }
  }
  std::vector<std::string> FirstRecords(std::size_t count) const {
    return {records.begin(), records.begin() + static_cast<std::ptrdiff_t>(count)};
  }

  std::string bytes = HeadOfLog();
  std::vector<std::string> records;
  std::vector<std::size_t> ends;
};

TEST(RobotLog, ReturnsWhatWasWritten) {
  const TemporaryFolder folder;
  RandomStream stream = NamedStream(1, "log");
  std::vector<std::string> records;
  RobotLogWriter writer(folder / "robot.log");
  for (int i = 0; i < 80; ++i) {
    const RobotCall call = AnyCall(stream);
    writer.Append(call);
    records.push_back(EncodeCall(call));
  }
  RobotLog log = ReadRobotLog(folder / "robot.log");  // while the writer is still at it
  ASSERT_EQ(log.size(), 80U);
  EXPECT_FALSE(log.torn_at());
  EXPECT_EQ(log.end(), fs::file_size(folder / "robot.log"));
  for (const std::size_t i : {79U, 0U, 40U, 41U}) {  // in any order
    EXPECT_EQ(EncodeCall(log.Read(i)), records[i]);
    EXPECT_EQ(log.KindAt(i), KindOf(log.Read(i)));
  }
  EXPECT_EQ(RecordsOf(std::move(log)), records);
}

TEST(RobotLog, EndsWithItsLastWholeRecordWhereverItBreaksOff) {
  const ShortLog whole;
  for (std::size_t size = 0; size <= whole.bytes.size(); ++size) {
    RobotLog log = LogOf(whole.bytes.substr(0, size));
    const auto count = static_cast<std::size_t>(
        std::count_if(whole.ends.begin(), whole.ends.end(), [&](std::size_t end) { return end <= size; }));
    const std::size_t end = count > 0 ? whole.ends[count - 1] : size < 12 ? 0 : 12;
    EXPECT_EQ(log.end(), end);
    EXPECT_EQ(log.torn_at(), end < size ? std::optional<std::uint64_t>(end) : std::nullopt) << size;
    EXPECT_EQ(RecordsOf(std::move(log)), whole.FirstRecords(count)) << size;
  }
}

TEST(RobotLog, NeverReturnsWhatWasNotWritten) {
  const ShortLog whole;
  int refused = 0;
  for (std::size_t bit = 0; bit < 8 * whole.bytes.size(); ++bit) {
    std::string bytes = whole.bytes;
    bytes[bit / 8] ^= static_cast<char>(1 << (bit % 8));
    const auto damaged = static_cast<std::size_t>(std::count_if(
        whole.ends.begin(), whole.ends.end(), [&](std::size_t end) { return end <= bit / 8; }));
    try {
      EXPECT_EQ(RecordsOf(LogOf(bytes)), whole.FirstRecords(damaged)) << "bit " << bit;
    } catch (const Error&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 8 * 12) << "the head, and what lies before the last note";
}

TEST(RobotLog, SaysWhereItIsDamagedInTheMiddle) {
  const ShortLog whole;
  std::string bytes = whole.bytes;
  bytes[whole.ends[0] + 3] ^= 1;
  EXPECT_THAT(
      ErrorOf([&] { LogOf(bytes); }),
      HasSubstr(fmt::format("run/robot.log: byte {}: the log is damaged there, and goes on at byte {};",
                            whole.ends[0], whole.ends[2])))
      << "with the scan";
  bytes = whole.bytes;
  bytes[whole.ends[9] - 1] ^= 1;
  EXPECT_EQ(RecordsOf(LogOf(bytes)).size(), 9U) << "nothing safe follows: so ends a power failure";
}

TEST(RobotLog, TakesZerosAtItsEndForNoRecords) {
  const ShortLog whole;
  RobotLog log = LogOf(whole.bytes + std::string(5000, '\0'));
  EXPECT_EQ(log.torn_at(), whole.bytes.size());
  EXPECT_EQ(RecordsOf(std::move(log)), whole.records);
}

TEST(RobotLog, RefusesOtherFiles) {
  const TemporaryFolder folder;
  EXPECT_THAT(ErrorOf([&] { LogOf("# a text"); }), HasSubstr("run/robot.log: is not the log of a robot"));
  std::string newer = HeadOfLog();
  newer[8] = 2;
  EXPECT_THAT(ErrorOf([&] { LogOf(newer); }), HasSubstr("is a log of version 2, and this program reads"));
  EXPECT_THAT(ErrorOf([&] { ReadRobotLog(folder.path()); }), HasSubstr("is a folder"));
  EXPECT_THAT(ErrorOf([&] { ReadRobotLog(folder / "none"); }), HasSubstr("there is no such file"));
  const std::string payload(1, '\x1F');
  const std::string head = slam::testing_support::Bytes(std::uint32_t{1}, FrameCrc(1, payload));
  EXPECT_THAT(ErrorOf([&] { LogOf(HeadOfLog() + head + payload); }),
              HasSubstr("byte 12: a record of a kind"));
}

TEST(RobotLogWriter, GoesOnWhereALogBrokeOff) {
  const TemporaryFolder folder;
  const ShortLog whole;
  const Note more{"more"};
  for (const std::size_t size : {0UL, 5UL, 12UL, whole.ends[3], whole.ends[3] + 1, whole.ends[4] - 1}) {
    const fs::path path = folder.Write("robot.log", whole.bytes.substr(0, size));
    RobotLogWriter(path).Append(more);
    auto expected = RecordsOf(LogOf(whole.bytes.substr(0, size)));
    expected.push_back(EncodeCall(more));
    EXPECT_EQ(RecordsOf(ReadRobotLog(path)), expected);
  }
}

TEST(RobotLogWriter, LeavesOtherFilesAlone) {
  const TemporaryFolder folder;
  const fs::path path = folder.Write("notes.txt", "what I never want to lose");
  EXPECT_THAT(ErrorOf([&] { RobotLogWriter writer(path); }), HasSubstr("is not the log of a robot"));
  EXPECT_EQ(ContentOf(path), "what I never want to lose");
}

TEST(RobotLogWriter, IsTheOnlyOne) {
  const TemporaryFolder folder;
  const fs::path path = folder / "robot.log";
  {
    const RobotLogWriter writer(path);
    EXPECT_THAT(ErrorOf([&] { RobotLogWriter second(path); }), HasSubstr("another program is writing"));
  }
  RobotLogWriter(path).Append(NowCall{});
}

TEST(RobotLogWriter, SaysWhyItCannotWrite) {
  EXPECT_EQ(
      ErrorOf([] { RobotLogWriter writer("/dev/full"); }),
      "/dev/full: cannot be written: No space left on device; free some space or choose another disk");
  EXPECT_THAT(ErrorOf([] { RobotLogWriter writer("/nowhere/robot.log"); }),
              HasSubstr("/nowhere/robot.log: cannot be written: No such file or directory"));
}

TEST(RobotLogWriter, LeavesAWholeLogOnADiskThatIsFull) {
  const TemporaryFolder folder;
  const fs::path path = folder / "robot.log";
  RobotLogWriter writer(path);
  writer.Append(NowCall{1.0});
  {
    const FullDisk disk(fs::file_size(path) + 10);
    EXPECT_THAT(ErrorOf([&] { writer.Append(NowCall{2.0}); }),
                HasSubstr("robot.log: cannot be written: File too large; free some space"));
  }
  EXPECT_THAT(ErrorOf([&] { writer.Append(NowCall{3.0}); }), HasSubstr("could not be written before"))
      << "nothing can be read behind half a record";
  const RobotLog log = ReadRobotLog(path);
  EXPECT_EQ(log.size(), 1U);
  EXPECT_EQ(log.torn_at(), 12U + 8U + 9U);
}

}  // namespace
}  // namespace ariadne::drivers
