#include "slam/io/stream_reader.h"

#include <gmock/gmock.h>

#include <sstream>

#include "tests/slam/io/support.h"

namespace ariadne::slam {
namespace {

using testing::HasSubstr;
using testing_support::ErrorOf;

/// A stream that cannot be rewound, as a pipe.
class OneWayBuffer final : public std::stringbuf {
 public:
  using std::stringbuf::stringbuf;

 protected:
  pos_type seekoff(off_type, std::ios::seekdir, std::ios::openmode) override {
    return pos_type(off_type(-1));
  }
  pos_type seekpos(pos_type, std::ios::openmode) override { return pos_type(off_type(-1)); }
};

TEST(StreamReader, ReadsLinesWithAnyEnd) {
  std::istringstream in("one\r\n\ntwo\nthree");
  StreamReader reader(in, "f");
  EXPECT_EQ(reader.NextLine(), "one");
  EXPECT_EQ(reader.NextLine(), "");
  EXPECT_EQ(reader.PeekLine(), "two");
  EXPECT_EQ(reader.NextLine(), "two");
  EXPECT_EQ(reader.line(), 3U);
  EXPECT_EQ(reader.NextLine(), "three");
  EXPECT_EQ(reader.NextLine(), std::nullopt);
  EXPECT_EQ(reader.line(), 4U);
}

TEST(StreamReader, KnowsItsPlace) {
  std::istringstream in("header\n0123456789");
  StreamReader reader(in, "f");
  EXPECT_EQ(reader.Remaining(), 17U);
  reader.NextLine();
  EXPECT_EQ(reader.offset(), 7U);
  EXPECT_EQ(reader.NextBytes(4), "0123");
  EXPECT_EQ(reader.Remaining(), 6U);
  EXPECT_EQ(reader.NextBytes(100), "456789");
  EXPECT_EQ(reader.NextBytes(1), "");
}

TEST(StreamReader, CrossesItsChunks) {
  std::string text;
  while (text.size() < 3 * StreamReader::kChunkSize) text += std::to_string(text.size()) + "\n";
  std::istringstream in(text);
  EXPECT_EQ(CountLineEnds(in), std::count(text.begin(), text.end(), '\n'));
  StreamReader reader(in, "f");
  std::size_t at = 0;
  while (const auto line = reader.NextLine()) {
    ASSERT_EQ(*line, std::to_string(at));
    at += line->size() + 1;
  }
  EXPECT_EQ(at, text.size());
}

TEST(StreamReader, RefusesEndlessLines) {
  std::istringstream in("short\n" + std::string(2 * StreamReader::kChunkSize, 'x'));
  StreamReader reader(in, "f");
  reader.NextLine();
  EXPECT_THAT(ErrorOf([&] { reader.NextLine(); }), HasSubstr("f:2: the line is longer than 1048576 bytes"));
}

TEST(StreamReader, ReadsWhatCannotBeRewound) {
  OneWayBuffer buffer("a\nb");
  std::istream in(&buffer);
  EXPECT_EQ(CountLineEnds(in), std::nullopt);
  StreamReader reader(in, "f");
  EXPECT_EQ(reader.Remaining(), std::nullopt);
  EXPECT_EQ(reader.NextLine(), "a");
  EXPECT_EQ(reader.NextLine(), "b");
}

TEST(Quoted, ShortensAndEscapes) {
  EXPECT_EQ(Quoted("1.0abc"), "'1.0abc'");
  EXPECT_EQ(Quoted("a\x01"), "'a\\x01'");
  EXPECT_EQ(Quoted(std::string(50, 'a')), "'" + std::string(40, 'a') + "...'");
}

}  // namespace
}  // namespace ariadne::slam
