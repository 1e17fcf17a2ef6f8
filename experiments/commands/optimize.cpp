#include "experiments/studies/optimize.h"

#include <fmt/format.h>

#include "experiments/commands/commands.h"
#include "experiments/commands/run_target.h"
#include "experiments/config/options_io.h"
#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

struct OptimizeArguments {
  std::string file;
  std::string config;
  std::string robust;
  std::string objective;
  std::string start;
  bool certify = false;
  bool covariances = false;
  std::vector<std::string> assignments;
  RunTarget target;
};

/// The options of the config file, if any, changed by the command line.
OptimizeOptions ResolveOptions(const OptimizeArguments& arguments) {
  OptionEntries entries =
      arguments.config.empty() ? OptionEntries() : OptionEntries::FromFile(arguments.config);
  const std::optional<OptionEntry> experiment = entries.Take("experiment");
  if (experiment && experiment->value != "optimize") {
    Fail("{}: the experiment is {}, not optimize; use ariadne run", experiment->where, experiment->value);
  }
  if (!arguments.file.empty()) entries.Set("file=" + arguments.file);
  if (!arguments.robust.empty()) entries.Set("graph.robust=" + arguments.robust);
  if (!arguments.objective.empty()) entries.Set("objective=" + arguments.objective);
  if (!arguments.start.empty()) entries.Set("graph.start=" + arguments.start);
  if (arguments.certify) entries.Set("certify=true");
  if (arguments.covariances) entries.Set("covariances=true");
  for (const std::string& assignment : arguments.assignments) entries.Set(assignment);
  return ReadOptions<OptimizeOptions>(entries);
}

int OptimizeGraph(const OptimizeArguments& arguments) {
  const OptimizeOptions options = ResolveOptions(arguments);
  CheckOptimizeInput(options);  // what is wrong is told before anything is made or overwritten
  const RunDirectory run(arguments.target.out, arguments.target.existing());
  ProgressDisplay progress(arguments.target.quiet);
  const OptimizeSummary summary = NotingFailure(run, [&] { return RunOptimize(options, run, progress); });
  fmt::print("{}results in {} (README.txt there says what is what)\n", summary.text, run.path().string());
  if (summary.problem.empty()) return 0;
  fmt::print(stderr, "ariadne: {}\n", summary.problem);
  return 1;
}

}  // namespace

void AddOptimizeCommand(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("optimize", "Find the best poses of a pose graph (.g2o)");
  auto arguments = std::make_shared<OptimizeArguments>();
  command->add_option("file", arguments->file,
                      "Graph in the format of g2o or TORO, in the plane or in space");
  command->add_option("--config", arguments->config, "YAML file of options");
  command->add_option("--objective", arguments->objective, "both, information or isotropic");
  command->add_option("--start", arguments->start, "auto, chordal, guess or odometry");
  command->add_option("--robust", arguments->robust,
                      "Against wrong closures: gnc, huber, cauchy, geman_mcclure, dcs or switchable");
  command->add_flag("--certify", arguments->certify, "Prove that there is no better minimum");
  command->add_flag("--covariances", arguments->covariances, "Write how certain each pose is");
  command->add_option("--out", arguments->target.out, "Run directory")->required();
  AddSetFlag(*command, arguments->assignments);
  AddRunFlags(*command, arguments->target);
  command->footer(
      "Example:\n  ariadne optimize sphere2500.g2o --certify --out results/sphere\n"
      "Exit status: 0; 1 for an error, or if no minimum was found; 2 for wrong arguments.");
  command->callback([arguments, &status] { status = OptimizeGraph(*arguments); });
}

}  // namespace ariadne::experiments
