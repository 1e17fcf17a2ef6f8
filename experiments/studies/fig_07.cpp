#include "experiments/studies/fig_07.h"

#include <fmt/format.h>

#include "experiments/render/compose.h"
#include "experiments/render/png_file.h"
#include "experiments/run/manifest.h"
#include "experiments/run/run_page.h"
#include "experiments/studies/plan_pictures.h"
#include "slam/base/error.h"
#include "slam/base/numbers.h"

namespace ariadne::experiments {
namespace {

/// Both in the map, the second where matching puts it.
std::vector<slam::PosedCloud> RegisteredPair(const ScanSource& source, const slam::MapperOptions& options) {
  slam::Mapper mapper(options);
  std::vector<slam::PosedCloud> scans;
  for (std::size_t i = 0; i < 2; ++i) {
    scans.push_back(source.Read(i));
    mapper.AddScan(scans[i]);
    scans[i].T_map_laser = mapper.scans()[i].T_map_laser;
    const auto [min_range, max_range] = options.scan;
    scans[i].cloud_laser = slam::WithinRange(scans[i].cloud_laser, min_range, max_range);
  }
  return scans;
}

Image PolygonPanel(std::span<const planning::LabelledPolygon> polygons, std::span<const slam::Pose2> robots,
                   std::span<const Eigen::Vector2d> places, int width, std::string_view title) {
  PlanCanvas canvas(places, width);
  canvas.Area(polygons);
  canvas.Edges(polygons);
  for (const slam::Pose2& T_map_robot : robots) canvas.Robot(T_map_robot, PlanColors::kRobot);
  return canvas.Finished(title);
}

std::vector<std::string> PolygonRow(const std::string& name,
                                    std::span<const planning::LabelledPolygon> polygons) {
  double area = 0.0, seen = 0.0, unseen = 0.0;
  for (const planning::LabelledPolygon& polygon : polygons) {
    area += slam::Area(planning::ToPolygon2(polygon));
    seen += planning::SeenLength(polygon);
    unseen += planning::UnseenLength(polygon);
  }
  return {name, Exact(area), Exact(seen), Exact(unseen)};
}

}  // namespace

std::string RunFig07(const Fig07Options& options, const RunDirectory& run, ProgressDisplay&) {
  const ScanSource source(options.input);
  if (source.size() < 2) Fail("fig_07 needs two scans; the input has {}", source.size());
  WriteManifest(run, source.Files());
  const PlanStep step = PlanNextScan(RegisteredPair(source, options.mapper), options.step);
  const std::vector<slam::Pose2> robots{step.slices[0].T_map_scan, step.slices[1].T_map_scan};
  const std::vector<Eigen::Vector2d> places = CornersOf(step.area);
  std::vector<Image> panels;
  Table table{{"polygon", "area_m2", "seen_m", "unseen_m"}, {}};
  for (std::size_t i = 0; i < 2; ++i) {
    const std::span polygon(&step.polygons[i], 1);
    panels.push_back(PolygonPanel(polygon, std::span(&robots[i], 1), places, options.width,
                                  fmt::format("({}) Scan {}", i == 0 ? "a" : "b", i + 1)));
    table.rows.push_back(PolygonRow(fmt::format("scan {}", i + 1), polygon));
  }
  panels.push_back(PolygonPanel(step.area, robots, places, options.width, "(c) Their union"));
  table.rows.push_back(PolygonRow("union", step.area));
  const std::vector<LegendEntry> legend{{"seen", PlanColors::kSeen},
                                        {"unseen (dashed)", PlanColors::kUnseen},
                                        {"scanner", PlanColors::kRobot}};
  WritePng(run.File("figures/fig_07.png"),
           WithLegend(Grid(panels, {.columns = 1}), legend, {.cap_height = 20.0}));
  run.WriteCsv("polygons.csv", table);
  FinishRun(run, "Fig. 7: labelled polygons and their union", panels.size());
  return ToText(table);
}

}  // namespace ariadne::experiments
