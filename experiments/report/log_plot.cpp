#include "experiments/report/log_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

constexpr double kWidth = 640.0, kHeight = 420.0;
constexpr double kLeft = 64.0, kRight = 20.0, kTop = 20.0, kBottom = 52.0;  // margins
constexpr double kRow = 18.0;                                               // of the legend
constexpr std::array kPlotColors{"#1b69c7", "#e07b00", "#008c73", "#8e44ad", "#555555"};

/// From the logarithms of values to places on the page.
struct LogScale {
  double low = 0.0, high = 1.0;   // log10
  double begin = 0.0, end = 1.0;  // on the page
  double At(double value) const { return begin + (std::log10(value) - low) / (high - low) * (end - begin); }
};

/// Rounded outwards to 1, 2 or 5 times a power of ten.
double RoundedLog(double value, bool up) {
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  constexpr std::array kSteps{1.0, 2.0, 5.0, 10.0};
  double rounded = decade * (up ? kSteps.back() : kSteps.front());
  for (const double step : kSteps) {
    if (!up && step * decade <= value * (1.0 + 1e-9)) rounded = step * decade;
  }
  for (std::size_t i = kSteps.size(); up && i-- > 0;) {
    if (kSteps[i] * decade >= value * (1.0 - 1e-9)) rounded = kSteps[i] * decade;
  }
  return std::log10(rounded);
}

LogScale ScaleOf(const std::vector<double>& values, double begin, double end) {
  const auto [least, most] = std::ranges::minmax(values);
  LogScale scale{RoundedLog(least, false), RoundedLog(most, true), begin, end};
  if (scale.low == scale.high) scale.high += 1.0;
  return scale;
}

/// 1, 2 and 5 times each power of ten within a scale.
std::vector<double> TicksOf(const LogScale& scale) {
  std::vector<double> ticks;
  for (double decade = std::floor(scale.low); decade <= scale.high; decade += 1.0) {
    for (const double step : {1.0, 2.0, 5.0}) {
      const double at = decade + std::log10(step);
      if (at > scale.low - 1e-9 && at < scale.high + 1e-9) ticks.push_back(step * std::pow(10.0, decade));
    }
  }
  return ticks;
}

std::string PlotLine(double x1, double y1, double x2, double y2, const std::string& style) {
  return fmt::format(R"(<line x1="{:.1f}" y1="{:.1f}" x2="{:.1f}" y2="{:.1f}" {}/>)"
                     "\n",
                     x1, y1, x2, y2, style);
}

std::string PlotText(double x, double y, const std::string& text, const std::string& more) {
  return fmt::format(R"(<text x="{:.1f}" y="{:.1f}" {}>{}</text>)"
                     "\n",
                     x, y, more, text);
}

std::string PlotGrid(const LogScale& x, const LogScale& y) {
  std::string svg;
  for (const double tick : TicksOf(x)) {
    svg += PlotLine(x.At(tick), y.begin, x.At(tick), y.end, R"(stroke="#ddd")");
    svg += PlotText(x.At(tick), y.begin + 18.0, fmt::format("{:g}", tick), R"(text-anchor="middle")");
  }
  for (const double tick : TicksOf(y)) {
    svg += PlotLine(x.begin, y.At(tick), x.end, y.At(tick), R"(stroke="#ddd")");
    svg += PlotText(x.begin - 6.0, y.At(tick) + 4.0, fmt::format("{:g}", tick), R"(text-anchor="end")");
  }
  return svg;
}

std::string PlotSeries(const LogSeries& series, const std::string& color, const LogScale& x,
                       const LogScale& y) {
  std::string line, dots;
  for (const Eigen::Vector2d& p : series.points) {
    line += fmt::format("{:.1f},{:.1f} ", x.At(p.x()), y.At(p.y()));
    dots += fmt::format(R"(<circle cx="{:.1f}" cy="{:.1f}" r="3.5" fill="{}"/>)"
                        "\n",
                        x.At(p.x()), y.At(p.y()), color);
  }
  return fmt::format(R"(<polyline points="{}" fill="none" stroke="{}" stroke-width="2"/>)"
                     "\n{}",
                     line, color, dots);
}

}  // namespace

std::string LogPlot(std::span<const LogSeries> series, std::span<const LogLevel> levels,
                    const std::string& x_title, const std::string& y_title) {
  std::vector<double> xs, ys;
  for (const LogSeries& one : series) {
    for (const Eigen::Vector2d& p : one.points) {
      if (!(p.minCoeff() > 0.0 && p.allFinite()))
        Fail("the plot's {} has the point ({}, {}), which has no logarithm", one.name, p.x(), p.y());
      xs.push_back(p.x());
      ys.push_back(p.y());
    }
  }
  if (xs.empty()) Fail("there is nothing to plot over {}", x_title);
  for (const LogLevel& level : levels) {
    if (!(level.y > 0.0 && std::isfinite(level.y)))
      Fail("the plot's level {} is {}, which has no logarithm", level.name, level.y);
    ys.push_back(level.y);
  }
  const LogScale x = ScaleOf(xs, kLeft, kWidth - kRight),
                 y = ScaleOf(ys, kHeight - kBottom, kTop + kRow * static_cast<double>(series.size()));
  std::string svg = fmt::format(
      R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {:.0f} {:.0f}" font-family="sans-serif" font-size="13">)"
      "\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
      kWidth, kHeight);
  svg += PlotGrid(x, y);
  svg += PlotText(0.5 * (x.begin + x.end), kHeight - 12.0, x_title, R"(text-anchor="middle")");
  svg += PlotText(0.0, 0.0, y_title,
                  fmt::format(R"svg(text-anchor="middle" transform="translate(16 {:.0f}) rotate(-90)")svg",
                              0.5 * (y.begin + y.end)));
  for (const LogLevel& level : levels) {
    svg +=
        PlotLine(x.begin, y.At(level.y), x.end, y.At(level.y), R"(stroke="#a00" stroke-dasharray="6 4")");
  }
  for (std::size_t i = 0; i < series.size(); ++i) {
    const std::string color = kPlotColors[i % kPlotColors.size()];
    const double row = kTop + 4.0 + kRow * static_cast<double>(i);  // above the plot
    svg += PlotSeries(series[i], color, x, y);
    svg += PlotLine(x.begin + 10.0, row - 4.0, x.begin + 30.0, row - 4.0,
                    fmt::format(R"(stroke="{}" stroke-width="2")", color));
    svg += PlotText(x.begin + 36.0, row, series[i].name, "");
  }
  for (const LogLevel& level : levels) {  // readable where a curve passes
    svg +=
        PlotText(x.end - 4.0, y.At(level.y) - 5.0, level.name,
                 R"(text-anchor="end" fill="#a00" stroke="white" stroke-width="4" paint-order="stroke")");
  }
  return svg + "</svg>\n";
}

}  // namespace ariadne::experiments
