#include "experiments/studies/plan_sorting.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "slam/geometry/angles.h"

namespace ariadne::experiments {
namespace {

constexpr double kShortest = 0.4;  // of a line that is worth showing [m]
constexpr Rgb kSightLine{150, 156, 165};

double BearingFrom(const slam::Pose2& T_map_scan, const Eigen::Vector2d& p_map) {
  const Eigen::Vector2d p = p_map - T_map_scan.translation;
  return std::atan2(p.y(), p.x());
}

/// From the left end of one line to the right end of the next [rad].
double AngleBetween(const slam::Pose2& T_map_scan, const Segment& line, const Segment& next) {
  return slam::WrapAngle(BearingFrom(T_map_scan, next.first) - BearingFrom(T_map_scan, line.second));
}

std::vector<Segment> LongLines(const planning::LabelledPolygon& polygon) {
  std::vector<Segment> lines = SegmentsOf(std::span(&polygon, 1), true);
  std::erase_if(lines, [](const Segment& line) { return (line.second - line.first).norm() < kShortest; });
  return lines;
}

/// The first of three lines in a row with angles between them that can be seen, and not too far away.
std::vector<Segment> ThreeLines(const std::vector<Segment>& lines, const slam::Pose2& T_map_scan) {
  std::vector<Segment> best;
  double most = 0.0;
  for (std::size_t i = 0; i + 2 < lines.size(); ++i) {
    const double first = AngleBetween(T_map_scan, lines[i], lines[i + 1]);
    const double second = AngleBetween(T_map_scan, lines[i + 1], lines[i + 2]);
    const double size = (lines[i].first - lines[i + 2].second).norm();
    const double worth = std::min({first, second, 0.5}) / (1.0 + 0.1 * size);
    if (worth <= most) continue;
    most = worth;
    best.assign(lines.begin() + static_cast<std::ptrdiff_t>(i),
                lines.begin() + static_cast<std::ptrdiff_t>(i) + 3);
  }
  return best;
}

/// An arc about the scanner between two bearings.
std::vector<Segment> ArcAbout(const Eigen::Vector2d& center, double from, double angle, double radius) {
  constexpr int kPieces = 24;
  std::vector<Segment> arc;
  const auto at = [&](int i) -> Eigen::Vector2d {
    const double bearing = from + angle * i / kPieces;
    return center + radius * Eigen::Vector2d(std::cos(bearing), std::sin(bearing));
  };
  for (int i = 0; i < kPieces; ++i) arc.emplace_back(at(i), at(i + 1));
  return arc;
}

void DrawAngle(PlanCanvas& canvas, const slam::Pose2& T_map_scan, const Segment& line, const Segment& next,
               std::string_view name) {
  const Eigen::Vector2d& center = T_map_scan.translation;
  const double angle = AngleBetween(T_map_scan, line, next);
  const double from = BearingFrom(T_map_scan, line.second);
  const double radius = 0.55 * std::min((line.second - center).norm(), (next.first - center).norm());
  canvas.Lines(std::vector<Segment>{{center, line.second}, {center, next.first}},
               {.color = kSightLine, .width = 1.5});
  canvas.Lines(ArcAbout(center, from, angle, radius), {.color = PlanColors::kView, .width = 3.0});
  const double middle = from + 0.5 * angle;
  const Eigen::Vector2d u(std::cos(middle), std::sin(middle));
  canvas.Text(center + radius * u, name, PlanColors::kView, 26.0 * Eigen::Vector2d(u.x(), -u.y()));
}

}  // namespace

Image SortingPicture(const planning::LabelledPolygon& polygon, const slam::Pose2& T_map_scan, int width,
                     std::string_view title) {
  const std::vector<Segment> lines = LongLines(polygon);
  const std::vector<Segment> three = ThreeLines(lines, T_map_scan);
  std::vector<Eigen::Vector2d> places = CornersOf(std::span(&polygon, 1));
  places.push_back(T_map_scan.translation);
  PlanCanvas canvas(places, width);
  canvas.Lines(lines, {.color = kSightLine, .width = 2.0});
  for (std::size_t i = 0; i + 1 < three.size(); ++i) {
    canvas.Dashes(std::vector<Segment>{{three[i].second, three[i + 1].first}},
                  {.color = PlanColors::kUnseen, .width = 3.0});
    DrawAngle(canvas, T_map_scan, three[i], three[i + 1], i == 0 ? "a1" : "a2");
  }
  canvas.Lines(three, {.color = PlanColors::kSeen, .width = 5.0});
  for (std::size_t i = 0; i < three.size(); ++i) {
    const Eigen::Vector2d middle = 0.5 * (three[i].first + three[i].second);
    const Eigen::Vector2d out = (middle - T_map_scan.translation).normalized();
    canvas.Text(middle, fmt::format("{}", i + 1), PlanColors::kSeen,
                28.0 * Eigen::Vector2d(out.x(), -out.y()));
  }
  canvas.Robot(T_map_scan, PlanColors::kRobot);
  return canvas.Finished(title);
}

}  // namespace ariadne::experiments
