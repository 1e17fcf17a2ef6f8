#include "experiments/studies/fig_11.h"

#include <fmt/format.h>

#include <cmath>

#include "experiments/render/annotations.h"
#include "experiments/render/compose.h"
#include "experiments/render/fit_camera.h"
#include "experiments/render/png_file.h"
#include "experiments/report/map_cameras.h"
#include "experiments/report/model_pictures.h"
#include "experiments/run/manifest.h"
#include "experiments/run/run_page.h"
#include "slam/base/error.h"
#include "slam/base/numbers.h"

namespace ariadne::experiments {
namespace {

constexpr int kWholeCubes = 4;  // up to this depth cells are larger than rooms, and none is left out

std::vector<int> ParseDepths(const std::string& text) {
  std::vector<int> depths;
  for (const double depth : ParseNumbers(text, "depths")) {
    if (depth < 0.0 || depth > 40.0 || depth != std::floor(depth))
      Fail("depths: {} is no depth of an octree; give whole numbers from 0 on", depth);
    depths.push_back(static_cast<int>(depth));
  }
  return depths;
}

/// The cells that do not reach above a height.
std::vector<slam::OctreeCell> Below(double height, std::vector<slam::OctreeCell> cells) {
  std::erase_if(cells, [&](const slam::OctreeCell& c) { return c.center.z() + 0.5 * c.edge > height; });
  return cells;
}

/// From behind the scanner, around the cells.
Camera CameraAround(const std::vector<slam::OctreeCell>& cells, int width) {
  std::vector<Eigen::Vector3d> corners;
  for (const slam::OctreeCell& cell : cells) {
    const slam::Box3 cube(cell.center - Eigen::Vector3d::Constant(0.5 * cell.edge),
                          cell.center + Eigen::Vector3d::Constant(0.5 * cell.edge));
    for (int i = 0; i < 8; ++i) corners.push_back(cube.corner(static_cast<slam::Box3::CornerType>(i)));
  }
  const ObliqueOptions behind{.azimuth = 2.6, .elevation = 0.6, .size = {width, width * 3 / 4}};
  return Fitted(ObliqueView(Eigen::Vector3d::Zero(), behind), corners, {.outlier_share = 0.0});
}

}  // namespace

std::string RunFig11(const Fig11Options& options, const RunDirectory& run, ProgressDisplay& progress) {
  const ScanSource source(options.input);
  WriteManifest(run, source.Files());
  const slam::PosedCloud scan = source.Read(0);
  slam::Octree octree(options.octree);
  octree.Add(scan.cloud_laser, Eigen::Vector3d::Zero());
  const double below_ceiling = WithoutCeiling({{scan.name, scan.cloud_laser, {}}}).max;

  Table table{{"depth", "edge_m", "cells"}, {}};
  std::vector<Image> pictures;
  for (const int depth : ParseDepths(options.depths)) {
    progress.Show(fmt::format("depth {}", depth));
    const std::vector<slam::OctreeCell> cells = octree.Cells(depth);
    const std::vector<slam::OctreeCell> shown = depth <= kWholeCubes ? cells : Below(below_ceiling, cells);
    const std::string title =
        fmt::format("Depth {}: {} cubes of {:.3g} m", depth, cells.size(), cells[0].edge);
    pictures.push_back(WithTitle(
        VoxelPicture(shown, octree.has_reflectance(), CameraAround(shown, options.width)), title));
    table.rows.push_back({std::to_string(depth), Exact(cells[0].edge), std::to_string(cells.size())});
  }
  WritePng(run.File("figures/fig_11.png"), Grid(pictures, {.columns = 2}));
  run.WriteCsv("depths.csv", table);
  run.WriteJson("metrics.json", {{"points", octree.points()},
                                 {"leaves", octree.leaves()},
                                 {"max_depth", octree.max_depth()},
                                 {"bytes", octree.bytes()}});
  FinishRun(run, "Fig. 11: the octree at several depths", pictures.size());
  return ToText(table);
}

}  // namespace ariadne::experiments
