#include "drivers/hardware/line_log.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "slam/base/error.h"
#include "slam/base/random.h"

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
    record.kind = static_cast<LineRecord::Kind>(stream() % 4);
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

TEST_F(LineLogTest, HasFilesOfLimitedSize) {
  WriteSome(500);
  EXPECT_TRUE(fs::exists(folder_ / "log.8"));
  for (const fs::directory_entry& file : fs::directory_iterator(folder_)) EXPECT_LE(file.file_size(), 500U);
  EXPECT_EQ(ReadLineLog(folder_ / "log"), written_);
}

/// Wherever a kill or a full disk ends the file, all whole records before are read.
TEST_F(LineLogTest, LosesNothingButTheTornRecord) {
  WriteSome(1U << 20U);
  const fs::path path = folder_ / "log.0";
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

TEST_F(LineLogTest, SaysWhereAMiddleFileIsDamaged) {
  WriteSome(500);
  std::fstream file(folder_ / "log.3", std::ios::binary | std::ios::in | std::ios::out);
  file.seekp(30);
  file.put('\x55');
  file.close();
  EXPECT_THROW(ReadLineLog(folder_ / "log"), Error);
}

TEST_F(LineLogTest, TakesNoZerosForRecords) {
  EXPECT_FALSE(DecodeLineRecord(Bytes(100)));
  RandomStream stream = NamedStream(2, "flips");
  for (int i = 0; i < 500; ++i) {
    Bytes bytes = EncodeLineRecord(3, AnyRecord(stream));
    const std::size_t bit = stream() % (8 * bytes.size());
    bytes[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
    EXPECT_FALSE(DecodeLineRecord(bytes));
  }
}

}  // namespace
}  // namespace ariadne::drivers
