#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

namespace ariadne::experiments {

/// A line through points with markers, in units of the axes; both coordinates above 0.
struct LogSeries {
  std::string name;
  std::vector<Eigen::Vector2d> points;
};

/// A level that is not to be exceeded, dashed.
struct LogLevel {
  std::string name;
  double y = 0.0;
};

/// A plot with two logarithmic axes, as the text of an SVG file. Error where there are no points, or one
/// that no logarithm has a place for.
std::string LogPlot(std::span<const LogSeries> series, std::span<const LogLevel> levels,
                    const std::string& x_title, const std::string& y_title);

}  // namespace ariadne::experiments
