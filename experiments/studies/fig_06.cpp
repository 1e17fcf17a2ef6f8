#include "experiments/studies/fig_06.h"

#include "experiments/render/compose.h"
#include "experiments/render/png_file.h"
#include "experiments/run/manifest.h"
#include "experiments/run/run_page.h"
#include "experiments/studies/plan_output.h"
#include "experiments/studies/plan_pictures.h"

namespace ariadne::experiments {

std::string RunFig06(const Fig06Options& options, const RunDirectory& run, ProgressDisplay&) {
  const ScanSource source(options.input);
  WriteManifest(run, source.Files());
  slam::PosedCloud scan = source.Read(0);
  scan.cloud_laser = slam::WithinRange(scan.cloud_laser, options.scan.min_range, options.scan.max_range);
  const PlanStep step = PlanNextScan(std::span(&scan, 1), options.step);
  const std::vector<Image> panels = PlanningPanels(step, options.step, options.width);
  WritePng(run.File("figures/fig_06.png"),
           WithLegend(Grid(panels, {.columns = 2}), PlanLegend(), {.cap_height = 20.0}));
  slam::WriteSvg(run.File("fig_06.svg"), DrawingOf(step, options.step), options.svg);
  const Json metrics = ToJson(step);
  run.WriteJson("metrics.json", metrics);
  FinishRun(run, "Fig. 6: one step of planning", panels.size());
  return ToText(step);
}

}  // namespace ariadne::experiments
