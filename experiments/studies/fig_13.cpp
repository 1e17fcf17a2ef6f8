#include "experiments/studies/fig_13.h"

#include <fmt/format.h>

#include <algorithm>

#include "experiments/render/annotations.h"
#include "experiments/render/compose.h"
#include "experiments/render/fit_camera.h"
#include "experiments/render/mesh_view.h"
#include "experiments/render/png_file.h"
#include "experiments/report/map_cameras.h"
#include "experiments/report/plan_picture.h"
#include "experiments/report/scan_image.h"
#include "experiments/report/table.h"
#include "experiments/run/manifest.h"
#include "experiments/run/run_page.h"
#include "experiments/studies/box_views.h"
#include "experiments/studies/explore_model.h"

namespace ariadne::experiments {
namespace {

/// As wide as given: each pixel becomes a block, as the beams of a scan are few.
Image StretchedTo(const Image& image, int width) {
  const int height = std::max(1, image.height * width / image.width);
  Image stretched(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const int from_x = x * image.width / width, from_y = y * image.height / height;
      stretched.pixels[stretched.IndexOf(x, y)] = image.pixels[image.IndexOf(from_x, from_y)];
    }
  }
  return stretched;
}

std::vector<Segment> WayOf(std::span<const slam::Pose2> poses) {
  std::vector<Segment> way;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    if (poses[i].translation != poses[i - 1].translation)
      way.emplace_back(poses[i - 1].translation, poses[i].translation);
  }
  return way;
}

/// What was known after a scan, and the trajectory from there.
Image StepPanel(const ExploredStep& step, std::span<const Eigen::Vector2d> extent, int width) {
  PlanCanvas canvas(extent, width);
  canvas.Area(step.area);
  canvas.Edges(step.area, 2.0);
  canvas.Lines(WayOf(step.planned_map), {.color = PlanColors::kView, .width = 3.0});
  canvas.Robot(step.T_map_base(), PlanColors::kRobot);
  if (step.view) canvas.Robot({step.view->direction, step.view->p_map}, PlanColors::kView);
  return canvas.Finished("");
}

std::vector<Image> ScanPanels(const std::vector<ExploredStep>& steps, const std::vector<slam::Scan>& scans,
                              const Fig13Options& options) {
  const std::size_t count = std::min({static_cast<std::size_t>(options.scans), steps.size(), scans.size()});
  std::vector<Eigen::Vector2d> extent;
  for (std::size_t i = 0; i < count; ++i) {
    for (const Eigen::Vector2d& corner : CornersOf(steps[i].area)) extent.push_back(corner);
  }
  std::vector<Image> panels;
  for (std::size_t i = 0; i < count; ++i) {
    const Image reflectance = StretchedTo(DistortedReflectance(scans[i]), options.width);
    panels.push_back(
        WithTitle(Grid({reflectance, StepPanel(steps[i], extent, options.width)}, {.columns = 1, .gap = 8}),
                  fmt::format("Scan {}", i + 1), {.cap_height = 16.0}));
  }
  return panels;
}

/// The building from two sides, opened, with its boxes.
std::vector<Image> BoxPictures(const BuildingModel& model, double cut, int width) {
  slam::SurfaceModel lower = model.surfaces;
  std::erase_if(lower.objects, [&](const slam::ObjectBox& o) { return o.box.min().z() > cut; });
  const slam::TriangleMesh mesh = WithSolidBoxes(MeshBelow(model.mesh, cut), lower);
  std::vector<Image> pictures;
  if (mesh.triangles.empty()) return pictures;
  for (const double azimuth : {-2.0, 1.1}) {
    const ObliqueOptions view{.azimuth = azimuth, .elevation = 0.75, .size = {width, width}};
    const Camera camera = Fitted(ObliqueView(Eigen::Vector3d::Zero(), view), mesh.vertices,
                                 {.margin = 20, .adjust_height = true});
    pictures.push_back(RenderMesh(mesh, camera, {}, Parallel(1)));
  }
  return pictures;
}

Table StepTable(const std::vector<ExploredStep>& steps, std::size_t count) {
  Table table{{"scan", "seen_m", "unseen_m", "rays_of_next_view", "trajectory_m"}, {}};
  for (std::size_t i = 0; i < std::min(count, steps.size()); ++i) {
    double seen = 0.0, unseen = 0.0, way = 0.0;
    for (const planning::LabelledPolygon& polygon : steps[i].area) {
      seen += planning::SeenLength(polygon);
      unseen += planning::UnseenLength(polygon);
    }
    for (const Segment& piece : WayOf(steps[i].planned_map)) way += (piece.second - piece.first).norm();
    table.rows.push_back({std::to_string(i + 1), Exact(seen), Exact(unseen),
                          steps[i].view ? std::to_string(steps[i].view->gain) : "", Exact(way)});
  }
  return table;
}

}  // namespace

void CheckFig13(const Fig13Options& options) { CheckExploredRun(options.exploration); }

std::string RunFig13(const Fig13Options& options, const RunDirectory& run, ProgressDisplay& progress) {
  WriteManifest(run, {});
  const std::filesystem::path path = ExploredRunFor(options.exploration, run, progress);
  const ExploredRun explored = ReadExploredRun(path);
  progress.Show("scans and polygons");
  const std::vector<slam::Scan> scans = ReadScansAsTaken(path, static_cast<std::size_t>(options.scans));
  const std::vector<Image> panels = ScanPanels(explored.steps, scans, options);
  const std::vector<LegendEntry> legend{{"seen", PlanColors::kSeen},
                                        {"unseen (dashed)", PlanColors::kUnseen},
                                        {"robot", PlanColors::kRobot},
                                        {"next view, trajectory", PlanColors::kView}};
  WritePng(run.File("figures/fig_13_scans.png"),
           WithLegend(Grid(panels, {.columns = 3}), legend, {.cap_height = 20.0}));
  progress.Show("mesh and boxes");
  const BuildingModel model = IntegrateScans(RegisteredScans(explored), options.model);
  const std::vector<Image> boxes =
      BoxPictures(model, WithoutCeiling(explored.scans).max, 3 * options.width / 2);
  if (!boxes.empty())
    WritePng(run.File("figures/fig_13_boxes.png"),
             WithTitle(Grid(boxes), "Boxes around objects", {.cap_height = 20.0}));
  const Table table = StepTable(explored.steps, panels.size());
  run.WriteCsv("scans.csv", table);
  run.WriteJson("metrics.json",
                {{"scans", explored.scans.size()}, {"objects", model.surfaces.objects.size()}});
  FinishRun(run, "Fig. 13: the first scans of an exploration", panels.size());
  return ToText(table);
}

}  // namespace ariadne::experiments
