#include "experiments/studies/fig_05.h"

#include <fmt/format.h>

#include "experiments/render/compose.h"
#include "experiments/render/png_file.h"
#include "experiments/report/map_pictures.h"
#include "experiments/run/manifest.h"
#include "experiments/run/run_page.h"
#include "slam/reduce/reduce.h"

namespace ariadne::experiments {

std::string RunFig05(const Fig05Options& options, const RunDirectory& run, ProgressDisplay&) {
  const ScanSource source(options.input);
  WriteManifest(run, source.Files());
  run.WriteProgress("running", 0, 1);
  const slam::PointCloud all =
      slam::WithinRange(source.Read(0).cloud_laser, options.scan.min_range, options.scan.max_range);
  const slam::PointCloud reduced = slam::Reduce(all, options.reduce);
  const slam::PosedCloud frame{source.name(0), all, {}};
  constexpr double kEnlarged = 4.0, kSmall = 1.0;  // radius of a point in the picture [px]
  const Image left = ScanPicture({source.name(0), reduced, {}}, frame, kEnlarged,
                                 fmt::format("{} reduced points, enlarged", reduced.size()));
  const Image right = ScanPicture(frame, frame, kSmall, fmt::format("All {} points", all.size()));
  WritePng(run.File("figures/reduced_and_all.png"), Grid({left, right}, {.columns = 2}));
  run.WriteJson("metrics.json", {{"points", all.size()}, {"reduced_points", reduced.size()}});
  FinishRun(run, "Fig. 5: reduced points beside all points", 1);
  return fmt::format("{} points, {} reduced points: 1 of {:.1f}\n", all.size(), reduced.size(),
                     static_cast<double>(all.size()) / static_cast<double>(reduced.size()));
}

}  // namespace ariadne::experiments
