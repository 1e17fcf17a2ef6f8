#include "experiments/studies/fig_02.h"

#include <fmt/format.h>

#include "experiments/render/annotations.h"
#include "experiments/render/compose.h"
#include "experiments/render/png_file.h"
#include "experiments/report/model_pictures.h"
#include "experiments/report/scan_image.h"
#include "experiments/run/manifest.h"
#include "experiments/run/run_page.h"
#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

/// What the software of the scanner makes of a scan (Sec. 2.2.1).
struct Extracted {
  slam::Octree octree;
  std::vector<std::vector<slam::SpatialLine>> lines_laser;
  slam::SurfaceModel model_laser;
};

Extracted Extract(const slam::PointCloud& cloud_laser, const Fig02Options& options) {
  Extracted extracted{
      slam::Octree(options.octree), slam::SliceLines(cloud_laser, options.surfaces.extract.lines), {}};
  extracted.octree.Add(cloud_laser, Eigen::Vector3d::Zero());
  extracted.model_laser = slam::MakeSurfaceModel(
      slam::ExtractSurfaces(cloud_laser, options.surfaces.extract), options.surfaces);
  return extracted;
}

std::vector<Image> Panels(const Extracted& extracted, const Image& corrected, const Camera& camera) {
  const slam::Octree& octree = extracted.octree;
  Image boxes = corrected;
  DrawObjects(boxes, camera, extracted.model_laser.objects);
  return {WithTitle(corrected, "Reflectance, corrected"),
          WithTitle(VoxelPicture(octree.Cells(octree.max_depth()), octree.has_reflectance(), camera),
                    "Voxels of the octree"),
          WithTitle(LinesPicture(extracted.lines_laser, camera), "Lines"),
          WithTitle(SurfacesPicture(extracted.model_laser.surfaces_map, camera), "Surfaces"),
          WithTitle(ModelPicture(extracted.model_laser, camera), "Structure and objects"),
          WithTitle(boxes, "Objects")};
}

Json CountsOf(const slam::Scan& scan, const Extracted& extracted) {
  std::size_t lines = 0;
  for (const auto& of_slice : extracted.lines_laser) lines += of_slice.size();
  return {{"beams", scan.sweeps.front().ranges.size()},
          {"slices", scan.sweeps.size()},
          {"points", extracted.octree.points()},
          {"voxels", extracted.octree.leaves()},
          {"lines", lines},
          {"surfaces", extracted.model_laser.surfaces_map.size()},
          {"objects", extracted.model_laser.objects.size()}};
}

}  // namespace

std::string RunFig02(const Fig02Options& options, const RunDirectory& run, ProgressDisplay&) {
  if (options.input.folder != "builtin:tour") {
    Fail("fig_02 needs slices with reflectance: input.folder must be builtin:tour, not {}",
         options.input.folder);
  }
  WriteManifest(run, {});
  const SimulatedTour tour(options.input.tour);
  const auto first = static_cast<std::size_t>(options.input.first);
  if (first >= tour.size()) Fail("input.first is {}, but the tour has {} scans", first, tour.size());
  const slam::Scan scan = tour.TakeScan(first, Parallel(1));
  const Extracted extracted = Extract(slam::ToPointCloud(scan), options);

  const PictureSize size{options.width, options.width * 3 / 4};
  const Image corrected = CorrectedReflectance(scan, size.width, size.height, options.field_of_view);
  WritePng(run.File("figures/distorted.png"), DistortedReflectance(scan));
  const std::vector<Image> panels = Panels(extracted, corrected, AheadCamera(size, options.field_of_view));
  WritePng(run.File("figures/fig_02.png"), Grid(panels, {.columns = 2}));
  const Json counts = CountsOf(scan, extracted);
  run.WriteJson("metrics.json", counts);
  FinishRun(run, "Fig. 2: two persons in a corridor, from reflectance to objects", 1);
  return fmt::format("{}\n", counts.dump());
}

}  // namespace ariadne::experiments
