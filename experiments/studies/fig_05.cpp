#include "experiments/studies/fig_05.h"

#include <fmt/format.h>

#include "experiments/render/compose.h"
#include "experiments/render/png_file.h"
#include "experiments/report/map_pictures.h"
#include "experiments/run/manifest.h"
#include "experiments/run/run_page.h"
#include "slam/extract/slice_lines.h"
#include "slam/reduce/reduce.h"

namespace ariadne::experiments {

std::string RunFig05(const Fig05Options& options, const RunDirectory& run, ProgressDisplay&) {
  const ScanSource source(options.input);
  WriteManifest(run, source.Files());
  run.WriteProgress("running", 0, 1);
  const slam::PointCloud all =
      slam::WithinRange(source.Read(0).cloud_laser, options.scan.min_range, options.scan.max_range);
  const slam::PointCloud reduced = slam::Reduce(all, options.reduce);
  const slam::PointCloud edges = slam::EdgePointCloud(all, options.lines);
  const slam::PosedCloud frame{source.name(0), all, {}};
  constexpr double kEnlarged = 4.0, kSmall = 1.0;  // radius of a point in the picture [px]
  const auto picture = [&](const slam::PointCloud& points, double radius, const char* kind) {
    return ScanPicture({source.name(0), points, {}}, frame, radius,
                       fmt::format("{} {}", points.size(), kind));
  };
  WritePng(run.File("figures/fig_05.png"),
           Grid({picture(edges, kEnlarged, "edge points"), picture(reduced, kEnlarged, "reduced points"),
                 picture(all, kSmall, "points")},
                {.columns = 3}));
  run.WriteJson(
      "metrics.json",
      {{"points", all.size()}, {"reduced_points", reduced.size()}, {"edge_points", edges.size()}});
  FinishRun(run, "Fig. 5: edge points, reduced points and all points", 1);
  const auto one_of = [&](std::size_t n) {
    return static_cast<double>(all.size()) / static_cast<double>(n);
  };
  return fmt::format("{} points, {} reduced points: 1 of {:.1f}, {} edge points: 1 of {:.1f}\n", all.size(),
                     reduced.size(), one_of(reduced.size()), edges.size(), one_of(edges.size()));
}

}  // namespace ariadne::experiments
