#include "experiments/studies/fig_09.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "experiments/render/draw.h"
#include "experiments/render/fit_camera.h"
#include "experiments/render/png_file.h"
#include "experiments/render/scales.h"
#include "experiments/report/table.h"
#include "experiments/run/manifest.h"
#include "experiments/run/run_page.h"
#include "slam/base/numbers.h"
#include "slam/geometry/angles.h"

namespace ariadne::experiments {
namespace {

using control::ApproachResult;
using slam::Pose2;

constexpr Rgb kApproachColor{46, 118, 190};
constexpr Rgb kStartColor{40, 44, 52};
constexpr Rgb kGoalColor{214, 64, 40};
constexpr double kArrow = 0.08;  // length of the robots' arrows, in radii of the circle

std::vector<Pose2> StartsOf(const Fig09Options& options) {
  std::vector<Pose2> starts;
  for (int i = 0; i < options.starts; ++i) {
    const double direction = 2.0 * std::numbers::pi * i / options.starts;
    starts.push_back({slam::RadFromDeg(options.heading),
                      {options.radius * std::cos(direction), options.radius * std::sin(direction)}});
  }
  return starts;
}

double LargestCurvature(const ApproachResult& path) {
  double largest = 0.0;
  for (const control::ApproachSample& sample : path.samples) {
    if (sample.command.forward == 0.0) continue;
    largest = std::max(largest, std::abs(sample.command.turning / sample.command.forward));
  }
  return largest;
}

/// A shaft with two barbs, along the heading.
std::vector<Polyline> Arrow(const Pose2& pose, double length) {
  const auto at = [&](double x, double y) { return pose * Eigen::Vector2d(x * length, y * length); };
  return {{at(0.0, 0.0), at(1.0, 0.0)}, {at(0.6, 0.25), at(1.0, 0.0), at(0.6, -0.25)}};
}

Polyline PlacesOf(const ApproachResult& path) {
  Polyline places;
  for (const control::ApproachSample& sample : path.samples)
    places.push_back(sample.T_map_robot.translation);
  return places;
}

std::vector<Polyline> InPicture(std::vector<Polyline> lines, const Camera& camera) {
  const Projector project(camera);
  for (Polyline& line : lines) {
    for (Eigen::Vector2d& p : line) {
      const ImagePoint point = project(Eigen::Vector3d(p.x(), p.y(), 0.0));
      p = {point.u, point.v};
    }
  }
  return lines;
}

Image PathsPicture(const std::vector<ApproachResult>& paths, const Fig09Options& options) {
  std::vector<Polyline> lines, starts;
  std::vector<Eigen::Vector3d> extent;
  for (const ApproachResult& path : paths) {
    lines.push_back(PlacesOf(path));
    for (const Eigen::Vector2d& p : lines.back()) extent.emplace_back(p.x(), p.y(), 0.0);
    for (const Polyline& line : Arrow(path.samples.front().T_map_robot, kArrow * options.radius)) {
      starts.push_back(line);
    }
  }
  const Camera camera = Fitted(TopView({options.width, options.width}), extent,
                               {.outlier_share = 0.0, .margin = options.width / 12});
  const double width = options.width / 700.0;
  Image canvas(camera.width, camera.height);
  DrawPolylines(canvas, InPicture(lines, camera), {.color = kApproachColor, .width = std::max(1.0, width)});
  DrawPolylines(canvas, InPicture(starts, camera), {.color = kStartColor, .width = std::max(1.0, width)});
  DrawPolylines(canvas, InPicture(Arrow({}, 1.5 * kArrow * options.radius), camera),
                {.color = kGoalColor, .width = std::max(1.0, 2.0 * width)});
  return WithScaleBar(canvas, camera);
}

std::vector<std::string> RowOf(const ApproachResult& path) {
  const Pose2& start = path.samples.front().T_map_robot;
  return {
      Exact(start.translation.x()),     Exact(start.translation.y()), Exact(slam::DegFromRad(start.angle)),
      std::string(NameOf(path.status)), Exact(path.length),           Exact(path.duration),
      Exact(LargestCurvature(path))};
}

}  // namespace

void CheckFig09(const Fig09Options& options) { control::RequireGains(options.approach.law); }

std::string RunFig09(const Fig09Options& options, const RunDirectory& run, ProgressDisplay& progress) {
  WriteManifest(run, {});
  progress.Show("paths");
  Table table{{"x_m", "y_m", "heading_deg", "status", "length_m", "duration_s", "max_curvature_per_m"}, {}};
  std::vector<ApproachResult> paths;
  std::vector<double> detours;
  for (const Pose2& start : StartsOf(options)) {
    paths.push_back(SimulateApproach(start, {}, options.approach));
    table.rows.push_back(RowOf(paths.back()));
    detours.push_back(paths.back().length / options.radius);
  }
  WritePng(run.File("figures/fig_09.png"), PathsPicture(paths, options));
  run.WriteCsv("paths.csv", table);
  const auto reached =
      std::ranges::count(paths, control::ApproachStatus::kReached, &ApproachResult::status);
  run.WriteJson("metrics.json", {{"paths", paths.size()},
                                 {"reached", reached},
                                 {"longest_over_straight", std::ranges::max(detours)}});
  FinishRun(run, "Fig. 9: paths to one pose from many", 1);
  return ToText(table);
}

}  // namespace ariadne::experiments
