#include "experiments/report/log_plot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "tests/support/error_of.h"

namespace ariadne::experiments {
namespace {

/// Where the marker number `i` lies.
Eigen::Vector2d MarkerAt(const std::string& svg, int i) {
  std::size_t at = 0;
  for (int k = 0; k <= i; ++k) at = svg.find("<circle cx=\"", at) + 1;
  const std::size_t x = svg.find("cx=\"", at) + 4, y = svg.find("cy=\"", at) + 4;
  return {std::stod(svg.substr(x)), std::stod(svg.substr(y))};
}

TEST(LogPlot, PutsEqualRatiosAtEqualDistances) {
  const std::vector<LogSeries> series{{"a", {{10.0, 1.0}, {20.0, 2.0}, {40.0, 4.0}}}};
  const std::string svg = LogPlot(series, {}, "x", "y");
  const Eigen::Vector2d first = MarkerAt(svg, 0), second = MarkerAt(svg, 1), third = MarkerAt(svg, 2);
  EXPECT_NEAR(second.x() - first.x(), third.x() - second.x(), 0.2);
  EXPECT_NEAR(second.y() - first.y(), third.y() - second.y(), 0.2);
  EXPECT_GT(second.x(), first.x());
  EXPECT_LT(second.y(), first.y()) << "upwards on the page";
}

TEST(LogPlot, ShowsNamesTitlesLevelsAndEverythingWithinThePage) {
  const std::vector<LogSeries> series{{"median", {{50.0, 3.0}, {800.0, 30.0}}}, {"most", {{50.0, 7.0}}}};
  const std::vector<LogLevel> levels{{"goal", 100.0}};
  const std::string svg = LogPlot(series, levels, "candidates", "time");
  for (const char* text : {">median<", ">most<", ">goal<", ">candidates<", ">time<", "</svg>"})
    EXPECT_THAT(svg, testing::HasSubstr(text));
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector2d at = MarkerAt(svg, i);
    EXPECT_TRUE(at.x() >= 64.0 && at.x() <= 620.0 && at.y() >= 20.0 && at.y() <= 368.0) << at.transpose();
  }
}

TEST(LogPlot, HasAPlaceForASinglePoint) {
  const std::vector<LogSeries> series{{"one", {{10.0, 10.0}}}};
  EXPECT_TRUE(MarkerAt(LogPlot(series, {}, "x", "y"), 0).allFinite());
}

TEST(LogPlot, RefusesWhatHasNoLogarithm) {
  const std::vector<LogSeries> zero{{"z", {{1.0, 0.0}}}}, none{{"n", {}}};
  const std::vector<LogSeries> infinite{{"i", {{1.0, std::numeric_limits<double>::infinity()}}}};
  EXPECT_THAT(ErrorOf([&] { LogPlot(zero, {}, "x", "y"); }), testing::HasSubstr("has no logarithm"));
  EXPECT_THAT(ErrorOf([&] { LogPlot(infinite, {}, "x", "y"); }), testing::HasSubstr("has no logarithm"));
  const std::vector<LogSeries> one{{"one", {{10.0, 10.0}}}};
  const std::vector<LogLevel> nothing{{"goal", 0.0}};
  EXPECT_THAT(ErrorOf([&] { LogPlot(one, nothing, "x", "y"); }), testing::HasSubstr("level goal is 0"));
  EXPECT_THAT(ErrorOf([&] { LogPlot(none, {}, "x", "y"); }), testing::HasSubstr("nothing to plot"));
}

}  // namespace
}  // namespace ariadne::experiments
