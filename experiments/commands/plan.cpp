#include "experiments/studies/plan.h"

#include <fmt/format.h>

#include <memory>

#include "experiments/commands/commands.h"
#include "experiments/commands/run_target.h"
#include "experiments/config/options_io.h"

namespace ariadne::experiments {
namespace {

struct PlanArguments {
  std::string run;
  std::vector<std::string> assignments;
  RunTarget target;
};

void Plan(const PlanArguments& arguments) {
  OptionEntries entries;
  entries.Set("run=" + arguments.run);
  for (const std::string& assignment : arguments.assignments) entries.Set(assignment);
  const auto options = ReadOptions<PlanStudyOptions>(entries);
  CheckPlanInput(options);
  const std::string out = arguments.target.out.empty() ? arguments.run + "/plan" : arguments.target.out;
  const RunDirectory run(out, arguments.target.existing());
  run.WriteConfig("experiment: plan\n" + WriteOptions(options));
  ProgressDisplay progress(arguments.target.quiet);
  fmt::print("{}", NotingFailure(run, [&] { return RunPlan(options, run, progress); }));
  fmt::print("results in {}: next_view.json, plan.svg, figures/plan.png\n", run.path().string());
}

}  // namespace

void AddPlanCommand(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("plan", "Where to scan next, from what the scans of a registered run show");
  auto arguments = std::make_shared<PlanArguments>();
  command->add_option("run", arguments->run, "Run directory of ariadne register")->required();
  command->add_option("--out", arguments->target.out, "Directory of the plan; without it: RUN/plan");
  AddSetFlag(*command, arguments->assignments);
  AddRunFlags(*command, arguments->target);
  command->footer(
      "Example:\n  ariadne plan results/garage --set height=0.8 --set planner.candidates.count=400\n"
      "where results/garage is what `ariadne register scans/garage13 --out results/garage` has left.");
  command->callback([arguments] { Plan(*arguments); });
}

}  // namespace ariadne::experiments
