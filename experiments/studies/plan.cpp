#include "experiments/studies/plan.h"

#include <fmt/format.h>

#include "experiments/render/png_file.h"
#include "experiments/run/manifest.h"
#include "experiments/run/run_page.h"
#include "experiments/studies/plan_output.h"
#include "experiments/studies/plan_pictures.h"
#include "experiments/studies/run_scans.h"
#include "slam/base/error.h"

namespace ariadne::experiments {

void CheckPlanInput(const PlanStudyOptions& options) {
  if (options.run.empty()) Fail("which run? Set run=DIR, the directory of a run of `register`");
  RunScans{options.run};
}

std::string RunPlan(const PlanStudyOptions& options, const RunDirectory& run, ProgressDisplay& progress) {
  const RunScans scans(options.run);
  WriteManifest(run, scans.source().Files());
  progress.Show(fmt::format("{} scans", scans.size()));
  const PlanStep step = PlanNextScan(ReadRegisteredMap(options.run).scans, options.step);
  run.WriteJson("next_view.json", ToJson(step));
  slam::WriteSvg(run.File("plan.svg"), DrawingOf(step, options.step), options.svg);
  const std::string title = step.plan.chosen ? "The next view" : "No next view";
  WritePng(run.File("figures/plan.png"),
           WithLegend(PlanPicture(step, options.step, options.width, title), PlanLegend()));
  run.WriteJson("metrics.json", ToJson(step));
  FinishRun(run, "Where to scan next", 1);
  return ToText(step);
}

}  // namespace ariadne::experiments
