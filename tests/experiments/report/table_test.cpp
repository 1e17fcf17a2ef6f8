#include "experiments/report/table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <numbers>

namespace ariadne::experiments {
namespace {

using testing::HasSubstr;

/// A table of one cell, as CSV without the header.
std::string CsvOf(const std::string& cell) { return ToCsv({{"c"}, {{cell}}}).substr(2); }

std::string LatexOf(const std::string& cell) { return ToLatex({{"c"}, {{cell}}}); }

TEST(ToCsv, JoinsCellsAndLines) {
  EXPECT_EQ(ToCsv({{"a", "b"}, {{"1", "2"}, {"", "x y"}}}), "a,b\n1,2\n,x y\n");
  EXPECT_EQ(ToCsv({{"only", "columns"}, {}}), "only,columns\n");
}

TEST(ToCsv, QuotesAsRfc4180) {
  EXPECT_EQ(CsvOf("a,b"), "\"a,b\"\n");
  EXPECT_EQ(CsvOf("say \"hi\""), "\"say \"\"hi\"\"\"\n");
  EXPECT_EQ(CsvOf("two\nlines"), "\"two\nlines\"\n");
  EXPECT_EQ(CsvOf("a\r"), "\"a\r\"\n");
  EXPECT_EQ(CsvOf("it's; a-b"), "it's; a-b\n");
  EXPECT_THAT(ToCsv({{"x, y"}, {}}), "\"x, y\"\n");
}

TEST(ToText, AlignsTextLeftAndNumbersRight) {
  EXPECT_EQ(ToText({{"scan", "rms cm"}, {{"first", "1.5"}, {"x", "12.25"}}}),
            "scan   rms cm\n"
            "first     1.5\n"
            "x       12.25\n");
}

TEST(ToText, CountsCharactersNotBytes) {
  EXPECT_EQ(ToText({{"name", "n"}, {{"Gänge", "1"}, {"Raum1", "2"}}}),
            "name   n\n"
            "Gänge  1\n"
            "Raum1  2\n");
}

TEST(ToText, LeavesNoBlanksAtTheEndsOfLines) {
  EXPECT_EQ(ToText({{"a", "message"}, {{"1", "ok"}, {"2", ""}}}), "a  message\n1  ok\n2\n");
  EXPECT_EQ(ToText({{"a", "b"}, {}}), "a  b\n");
}

TEST(ToLatex, MakesABooktabsTabular) {
  EXPECT_EQ(ToLatex({{"points", "time"}, {{"all", "6"}, {"reduced", "1.4"}}}),
            "\\begin{tabular}{lr}\n\\toprule\npoints & time \\\\\n\\midrule\n"
            "all & 6 \\\\\nreduced & 1.4 \\\\\n\\bottomrule\n\\end{tabular}\n");
}

TEST(ToLatex, EscapesWhatLatexReadsAsItsOwn) {
  EXPECT_THAT(LatexOf("50 % of a_b & #3"), HasSubstr("\n50 \\% of a\\_b \\& \\#3 \\\\\n"));
  EXPECT_THAT(LatexOf("$HOME {x}"), HasSubstr("\n\\$HOME \\{x\\} \\\\\n"));
  EXPECT_THAT(LatexOf("a\\b"), HasSubstr("\na\\textbackslash{}b \\\\\n"));
  EXPECT_THAT(LatexOf("~5 m^2"), HasSubstr("\n\\~{}5 m\\^{}2 \\\\\n"));
  EXPECT_THAT(ToLatex({{"rms_m"}, {}}), HasSubstr("{l}\n\\toprule\nrms\\_m \\\\\n"));
}

TEST(Exact, IsShortAndReadsBackToTheSameNumber) {
  EXPECT_EQ(Exact(0.1), "0.1");
  EXPECT_EQ(Exact(0.1 + 0.2), "0.30000000000000004");
  for (const double value : {std::numbers::pi, 1e-300, -1.0 / 3.0, std::numeric_limits<double>::max(),
                             std::numeric_limits<double>::denorm_min()}) {
    EXPECT_EQ(std::strtod(Exact(value).c_str(), nullptr), value);
  }
}

}  // namespace
}  // namespace ariadne::experiments
