#include "drivers/hardware/line_log.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <functional>

#include "slam/base/error.h"
#include "slam/base/random.h"
#include "tests/support/error_of.h"

namespace ariadne::drivers {
namespace {

namespace fs = std::filesystem;

class LineLogTest : public testing::Test {
 protected:
  LineLogTest() : folder_(fs::temp_directory_path() / ("ariadne_line_log_" + std::to_string(getpid()))) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~LineLogTest() override { fs::remove_all(folder_); }

  static LineRecord AnyRecord(RandomStream& stream) {
    LineRecord record;
    record.kind = static_cast<LineRecord::Kind>(stream() % 6);
    record.time = static_cast<double>(stream() % 1000000) * 1e-4;
    record.baud = static_cast<int>(stream() % 500000);
    record.bytes.resize(stream() % 60);
    for (std::uint8_t& byte : record.bytes) byte = static_cast<std::uint8_t>(stream() & 0xFF);
    return record;
  }

  /// Writes 100 records of two lines.
  void WriteSome(std::uintmax_t max_file_size) {
    RandomStream stream = NamedStream(1, "line log");
    LineLogWriter writer(folder_ / "log", max_file_size);
    for (int i = 0; i < 100; ++i) {
      const std::uint8_t line = stream() % 2 == 0 ? 1 : 7;
      written_[line].push_back(AnyRecord(stream));
      writer.Add(line, written_[line].back());
    }
  }

  fs::path folder_;
  std::map<std::uint8_t, std::vector<LineRecord>> written_;
};

TEST_F(LineLogTest, ReturnsWhatWasWritten) {
  WriteSome(1U << 20U);
  EXPECT_EQ(ReadLineLog(folder_ / "log"), written_);
  EXPECT_THROW(LineLogWriter(folder_ / "log"), Error);
  EXPECT_THROW(ReadLineLog(folder_ / "none"), Error);
}

TEST_F(LineLogTest, KeepsNotesAmongTheRecords) {
  {
    LineLogWriter writer(folder_ / "log");
    writer.Add(2, {LineRecord::Kind::kRead, 1.5, {7}});
    writer.Note("it was told to stop");
    writer.Add(2, {LineRecord::Kind::kRead, 2.5, {8}});
  }
  LineLogReader reader(folder_ / "log");
  EXPECT_EQ(reader.Next()->line, 2);
  const std::optional<LoggedRecord> note = reader.Next();
  EXPECT_EQ(note->line, kNotesLine);
  EXPECT_EQ(note->record.time, 1.5);
  EXPECT_EQ(Describe(note->record), "noted: it was told to stop");
  EXPECT_EQ(reader.Next()->record.bytes, Bytes{8});
  EXPECT_FALSE(reader.Next());
  EXPECT_FALSE(reader.Next()) << "the end stays the end";
  EXPECT_EQ(reader.files().records, 3U);
}

TEST_F(LineLogTest, HasFilesOfLimitedSize) {
  WriteSome(500);
  EXPECT_TRUE(fs::exists(folder_ / "log.008"));
  for (const fs::directory_entry& file : fs::directory_iterator(folder_)) EXPECT_LE(file.file_size(), 500U);
  EXPECT_EQ(ReadLineLog(folder_ / "log"), written_);
}

/// Wherever a kill or a full disk ends the file, all whole records before are read.
TEST_F(LineLogTest, LosesNothingButTheTornRecord) {
  WriteSome(1U << 20U);
  const fs::path path = folder_ / "log.000";
  std::size_t records = 100;
  for (std::uintmax_t size = fs::file_size(path); size > 0; size -= std::min<std::uintmax_t>(size, 7)) {
    fs::resize_file(path, size);
    std::size_t read = 0;
    for (const auto& [line, of_line] : ReadLineLog(folder_ / "log")) {
      read += of_line.size();
      const std::vector<LineRecord>& all = written_[line];
      EXPECT_TRUE(std::equal(of_line.begin(), of_line.end(), all.begin()));
    }
    EXPECT_LE(read, records);
    EXPECT_GE(read + 2, records);  // 7 bytes are of two records at most
    records = read;
  }
}

/// The order among lines is that of the calls, and what is torn is told.
TEST_F(LineLogTest, TellsWhatItIsMadeOf) {
  WriteSome(500);
  std::map<std::uint8_t, std::vector<LineRecord>> visited;
  std::vector<std::uint8_t> lines;
  const auto visit = [&](const LoggedRecord& logged) {
    visited[logged.line].push_back(logged.record);
    lines.push_back(logged.line);
  };
  const LineLogFiles whole = VisitLineLog(folder_ / "log", visit);
  EXPECT_EQ(visited, written_);
  EXPECT_NE(std::adjacent_find(lines.begin(), lines.end(), std::greater<>()), lines.end()) << "mixed";
  EXPECT_EQ(whole.records, 100U);
  EXPECT_EQ(whole.torn, 0U);
  const fs::path last = folder_ / fmt::format("log.{:03}", whole.files - 1);
  fs::resize_file(last, fs::file_size(last) - 1);
  const LineLogFiles torn = VisitLineLog(folder_ / "log", [](const LoggedRecord&) {});
  EXPECT_EQ(torn.records, 99U);
  EXPECT_EQ(torn.size, whole.size - 1);
  EXPECT_GT(torn.torn, 0U);
}

TEST_F(LineLogTest, SaysWhereAMiddleFileIsDamaged) {
  WriteSome(500);
  std::fstream file(folder_ / "log.003", std::ios::binary | std::ios::in | std::ios::out);
  file.seekp(30);
  file.put('\x55');
  file.close();
  EXPECT_THAT(ErrorOf([&] { ReadLineLog(folder_ / "log"); }), testing::HasSubstr("damaged at byte"));
}

TEST_F(LineLogTest, IsFoundByEachOfItsNames) {
  WriteSome(500);
  const std::vector<fs::path> log{folder_ / "log"};
  EXPECT_EQ(FindLineLogs(folder_), log);
  EXPECT_EQ(FindLineLogs(folder_ / "log"), log);
  EXPECT_EQ(FindLineLogs(folder_ / "log.002"), log);
  std::ofstream(folder_ / "other.000") << "something else";
  EXPECT_EQ(FindLineLogs(folder_), log);
  EXPECT_THROW(FindLineLogs(folder_ / "other.000"), Error);
  EXPECT_THROW(FindLineLogs(folder_ / "none"), Error);
}

/// Sweeps of a standing scanner differ by little, and most reads are empty.
TEST_F(LineLogTest, TakesAFractionOfTheBytesThatCrossedTheLine) {
  RandomStream stream = NamedStream(3, "sweeps");
  Bytes sweep(732);
  for (std::uint8_t& byte : sweep) byte = static_cast<std::uint8_t>(stream() & 0xFF);
  std::size_t crossed = 0;
  {
    LineLogWriter writer(folder_ / "log");
    for (int i = 0; i < 200; ++i) {
      for (int k = 0; k < 30; ++k) sweep[stream() % sweep.size()] ^= 1U;
      writer.Add(0, {LineRecord::Kind::kRead, 0.01 * i, sweep});
      writer.Add(0, {LineRecord::Kind::kRead, 0.01 * i + 0.005, {}});
      crossed += sweep.size();
    }
  }
  const LineLogFiles log = VisitLineLog(folder_ / "log", [](const LoggedRecord&) {});
  EXPECT_LT(static_cast<double>(log.size), 0.5 * static_cast<double>(crossed));
}

/// Each bit of a record counts, and zeros, as file systems leave them, are none.
TEST(LineLogStream, TakesNothingForARecordThatIsNone) {
  LineLogEncoder encoder;
  Bytes file = encoder.Begin();
  const std::size_t head = file.size();
  const Bytes record = encoder.Add({3, {LineRecord::Kind::kWrite, 1.5, {1, 2, 3}, 9600}});
  file.insert(file.end(), record.begin(), record.end());
  EXPECT_TRUE(LineLogDecoder(file).Next());
  for (std::size_t bit = 8 * head; bit < 8 * file.size(); ++bit) {
    Bytes damaged = file;
    damaged[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
    EXPECT_FALSE(LineLogDecoder(damaged).Next()) << bit;
  }
  Bytes zeros = encoder.Begin();
  zeros.resize(100);
  EXPECT_FALSE(LineLogDecoder(zeros).Next());
  EXPECT_THROW(LineLogDecoder(Bytes{'A', 'X'}), Error);
  EXPECT_FALSE(LineLogDecoder(Bytes{}).Next());
}

}  // namespace
}  // namespace ariadne::drivers
