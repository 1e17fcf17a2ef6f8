#include "experiments/studies/fig_02.h"

#include <fmt/format.h>

#include "experiments/render/png_file.h"
#include "experiments/report/scan_image.h"
#include "experiments/run/manifest.h"
#include "experiments/run/run_page.h"
#include "slam/base/error.h"

namespace ariadne::experiments {

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
  const Image distorted = DistortedReflectance(scan);
  WritePng(run.File("figures/distorted.png"), distorted);
  WritePng(run.File("figures/corrected.png"),
           CorrectedReflectance(scan, options.width, options.width * 3 / 4, options.field_of_view));
  run.WriteJson("metrics.json", {{"beams", distorted.width}, {"slices", distorted.height}});
  FinishRun(run, "Fig. 2: a corridor with two persons, as reflectance images", 1);
  return fmt::format("{} x {} beams\n", distorted.width, distorted.height);
}

}  // namespace ariadne::experiments
