#include "slam/io/row_parser.h"

#include <gmock/gmock.h>

#include <cmath>
#include <sstream>

#include "tests/slam/io/support.h"

namespace ariadne::slam {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing_support::ErrorOf;

std::vector<double> Parse(std::string_view line, std::string_view delimiters = "") {
  std::istringstream in;
  const StreamReader reader(in, "f");
  RowParser parser(reader, delimiters);
  const auto row = parser.Parse(line);
  return {row.begin(), row.end()};
}

TEST(RowParser, ParsesNumbers) {
  EXPECT_THAT(Parse(" 1 -2.5\t+3e2 .5 1e-320 "), ElementsAre(1.0, -2.5, 300.0, 0.5, 1e-320));
  EXPECT_THAT(Parse(""), ElementsAre());
  EXPECT_TRUE(std::isnan(Parse("nan").front()));
}

TEST(RowParser, ParsesDelimiters) {
  EXPECT_THAT(Parse("1,2;3 , 4", ",;"), ElementsAre(1.0, 2.0, 3.0, 4.0));
  EXPECT_THAT(ErrorOf([] { Parse("1,,2", ",;"); }), HasSubstr("'' is not a number"));
  EXPECT_THAT(ErrorOf([] { Parse("1,2,", ",;"); }), HasSubstr("missing after the last separator"));
}

TEST(RowParser, RefusesTextInNumbers) {
  EXPECT_THAT(ErrorOf([] { Parse("0 1.0abc 2"); }), HasSubstr("'1.0abc' is not a number"));
  EXPECT_THAT(ErrorOf([] { Parse("1,0 2,0"); }), HasSubstr("'1,0' is not a number"));
  EXPECT_THAT(ErrorOf([] { Parse("--1"); }), HasSubstr("'--1' is not a number"));
  EXPECT_THAT(ErrorOf([] { Parse("+-1"); }), HasSubstr("'+-1' is not a number"));
  EXPECT_THAT(ErrorOf([] { Parse("0x10"); }), HasSubstr("'0x10' is not a number"));
  EXPECT_THAT(ErrorOf([] { Parse("1e999"); }), HasSubstr("'1e999' is outside the range of a double"));
}

TEST(SplitAtBlanks, Splits) {
  EXPECT_THAT(SplitAtBlanks(" a \t bc  "), ElementsAre("a", "bc"));
  EXPECT_THAT(SplitAtBlanks("  "), ElementsAre());
}

TEST(ParseCount, AcceptsOnlyWholeNumbers) {
  EXPECT_EQ(ParseCount("18446744073709551615"), 18446744073709551615U);
  for (const char* word : {"", "-1", "+1", "1.0", "1x", "18446744073709551616"}) {
    EXPECT_EQ(ParseCount(word), std::nullopt) << word;
  }
}

}  // namespace
}  // namespace ariadne::slam
