#include "experiments/report/page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ariadne::experiments {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(ToHtml, EscapesWhatComesFromFiles) {
  const Page page{"a < b & \"c\"", {{"h>", {}, {{"x"}, {{"<script>"}}}, false}}, {}};
  const std::string html = ToHtml(page);
  EXPECT_THAT(html, HasSubstr("<h1>a &lt; b &amp; &quot;c&quot;</h1>"));
  EXPECT_THAT(html, HasSubstr("<td>&lt;script&gt;</td>"));
  EXPECT_THAT(html, Not(HasSubstr("<script>")));
}

TEST(ToHtml, ShowsPicturesAndLinksFiles) {
  const std::string html = ToHtml({"run", {{"Pictures", {"figures/top.png"}, {}, false}}, {"map.ply"}});
  EXPECT_THAT(html, HasSubstr("<img src=\"figures/top.png\""));
  EXPECT_THAT(html, HasSubstr("<a href=\"map.ply\">map.ply</a>"));
  EXPECT_THAT(html, Not(HasSubstr("<table>")));
}

TEST(ToHtml, FoldsLongTables) {
  const Table table{{"a"}, {{"1"}, {"2"}}};
  EXPECT_THAT(ToHtml({"run", {{"t", {}, table, true}}, {}}), HasSubstr("<summary>2 rows</summary>"));
  EXPECT_THAT(ToHtml({"run", {{"t", {}, table, false}}, {}}), Not(HasSubstr("<details>")));
}

TEST(FromCsv, ReadsWhatToCsvHasWritten) {
  const Table table{{"name", "it \"says\""}, {{"a,b", ""}, {"", "two\nlines"}, {"\"", "x"}}};
  const Table read = FromCsv(ToCsv(table));
  EXPECT_EQ(read.columns, table.columns);
  EXPECT_EQ(read.rows, table.rows);
}

}  // namespace
}  // namespace ariadne::experiments
