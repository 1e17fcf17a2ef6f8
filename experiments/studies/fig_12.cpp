#include "experiments/studies/fig_12.h"

#include <fmt/format.h>

#include "experiments/render/annotations.h"
#include "experiments/render/compose.h"
#include "experiments/render/density_view.h"
#include "experiments/render/fit_camera.h"
#include "experiments/render/mesh_view.h"
#include "experiments/render/overlay.h"
#include "experiments/render/png_file.h"
#include "experiments/render/scales.h"
#include "experiments/report/map_cameras.h"
#include "experiments/run/manifest.h"
#include "experiments/run/run_page.h"
#include "experiments/studies/box_views.h"
#include "experiments/studies/explore_model.h"

namespace ariadne::experiments {
namespace {

constexpr Rgb kWayInk{214, 64, 40};
constexpr Rgb kStopInk{24, 88, 160};
constexpr double kBoxEdge = 0.015;  // radius of the edges of boxes [m]

/// Of the points that stand between floor and ceiling.
HeightBand Upright(const std::vector<slam::PosedCloud>& scans) {
  const ValueRange heights = HeightRange(PositionsInMap(scans));
  const double height = heights.high - heights.low;
  return {.min = heights.low + 0.08 * height, .max = heights.low + 0.85 * height};
}

Camera MeshCamera(const slam::TriangleMesh& mesh, int width) {
  const ObliqueOptions view{.azimuth = -1.9, .elevation = 0.85, .size = {width, width}};
  return Fitted(ObliqueView(Eigen::Vector3d::Zero(), view), mesh.vertices,
                {.margin = 20, .adjust_height = true});
}

/// All panels have letters of one size.
Image Titled(const Image& panel, std::string_view title, int width) {
  return WithTitle(panel, title, {.cap_height = 0.012 * width});
}

std::vector<slam::Pose3> PosesOf(const std::vector<slam::PosedCloud>& scans) {
  std::vector<slam::Pose3> poses;
  for (const slam::PosedCloud& scan : scans) poses.push_back(scan.T_map_laser);
  return poses;
}

/// Two views of the boxes beside each other.
std::vector<Image> BoxViews(const BuildingModel& model, const std::vector<slam::PosedCloud>& scans,
                            int width) {
  const std::vector<slam::Pose3> poses = PosesOf(scans);
  const PictureSize size{width, width * 3 / 4};
  const slam::TriangleMesh with_boxes = WithBoxEdges(model.mesh, model.surfaces, kBoxEdge);
  std::vector<Image> views;
  for (const BoxView& view : BestViews(model, poses, 2, size)) {
    const std::string title =
        fmt::format("({}) Boxes around objects, from stop {}", views.empty() ? "c" : "d", view.pose + 1);
    views.push_back(Titled(RenderMesh(with_boxes, view.camera, {}, Parallel(1)), title, 2 * width));
  }
  return views;
}

}  // namespace

void CheckFig12(const Fig12Options& options) { CheckExploredRun(options.exploration); }

Image PathPicture(const ExploredRun& explored, int width) {
  const std::vector<slam::PosedCloud> scans = RegisteredScans(explored);
  const std::vector<Eigen::Vector3d> points = PositionsInMap(scans, Upright(scans));
  const Camera camera =
      Fitted(TopView({width, width}), points, {.outlier_share = 0.001, .adjust_height = true});
  const ColoredPoints ink{points, std::vector<Rgb>(points.size(), Rgb{60, 66, 76})};
  Image picture = RenderDensity(ink, camera);
  std::vector<Eigen::Vector3d> way;
  for (const Eigen::Vector2d& p : DrivenUpTo(explored.steps, explored.steps.size()))
    way.emplace_back(p.x(), p.y(), 0.0);
  DrawPath(picture, camera, way, {.color = kWayInk, .width = 2.5, .halo_width = 1.0});
  DrawPoses(picture, camera, PosesOf(explored.scans),
            {.radius = std::max(7.0, width / 150.0),
             .colored_by_index = false,
             .color = kStopInk,
             .first_number = 1});
  return WithScaleBar(picture, camera, {.cap_height = 0.012 * width});
}

std::string RunFig12(const Fig12Options& options, const RunDirectory& run, ProgressDisplay& progress) {
  WriteManifest(run, {});
  const ExploredRun explored = ReadExploredRun(ExploredRunFor(options.exploration, run, progress));
  progress.Show("the path");
  std::vector<Image> rows{Titled(PathPicture(explored, options.width),
                                 "(a) Map, path and stops of the exploration", options.width)};
  progress.Show("mesh and boxes");
  const BuildingModel model = IntegrateScans(RegisteredScans(explored), options.model);
  const slam::TriangleMesh opened = Lightened(MeshBelow(model.mesh, WithoutCeiling(explored.scans).max));
  if (!opened.triangles.empty()) {
    const Camera camera = MeshCamera(opened, options.width);
    rows.push_back(Titled(RenderMesh(opened, camera, {}, Parallel(1)), "(b) Mesh, without the ceiling",
                          options.width));
    rows.push_back(Grid(BoxViews(model, explored.scans, options.width / 2 - 12)));
  }
  WritePng(run.File("figures/fig_12.png"), Grid(rows, {.columns = 1}));
  double way = 0.0;
  const std::vector<Eigen::Vector2d> driven = DrivenUpTo(explored.steps, explored.steps.size());
  for (std::size_t i = 1; i < driven.size(); ++i) way += (driven[i] - driven[i - 1]).norm();
  run.WriteJson("metrics.json", {{"stops", explored.steps.size()},
                                 {"way_m", way},
                                 {"objects", model.surfaces.objects.size()},
                                 {"mesh_triangles", model.mesh.triangles.size()}});
  FinishRun(run, "Fig. 12: an exploration", rows.size());
  return fmt::format("{} stops, {:.0f} m, {} boxes around objects, {} triangles\n", explored.steps.size(),
                     way, model.surfaces.objects.size(), model.mesh.triangles.size());
}

}  // namespace ariadne::experiments
