#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "experiments/commands/commands.h"
#include "experiments/commands/run_target.h"
#include "experiments/studies/catalog.h"
#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

struct RunArguments {
  std::vector<std::string> configs;
  std::vector<std::string> assignments;
  std::string results = "results";
  RunTarget target;
};

/// Returns the exit status.
int RunConfig(const std::string& config, const RunArguments& arguments) {
  OptionEntries entries = OptionEntries::FromFile(config);
  for (const std::string& assignment : arguments.assignments) entries.Set(assignment);
  const std::optional<OptionEntry> experiment = entries.Take("experiment");
  if (!experiment)
    Fail("{}: the key experiment is missing; it says what to run (register, table_1, ...)", config);
  const Study& study = FindStudy(experiment->value, experiment->where);
  study.resolve(entries);  // what is wrong is told before anything is made or overwritten
  study.check_input(entries);
  const std::filesystem::path directory =
      arguments.target.out.empty()
          ? std::filesystem::path(arguments.results) / study.name / std::filesystem::path(config).stem()
          : std::filesystem::path(arguments.target.out);
  ProgressDisplay progress(arguments.target.quiet);
  progress.Keep(fmt::format("{}: {} ({})", config, study.summary, study.name));
  const RunDirectory run(directory, arguments.target.existing());
  const StudyResult result = NotingFailure(run, [&] { return study.run(entries, run, progress); });
  fmt::print("{}results in {}\n", result.text, directory.string());
  if (result.problem.empty()) return 0;
  fmt::print(stderr, "ariadne: {}\n", result.problem);
  return 1;
}

}  // namespace

void AddRunCommand(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("run", "Run experiments from their configs");
  auto arguments = std::make_shared<RunArguments>();
  command->add_option("configs", arguments->configs, "YAML files")->required();
  command->add_option("--out", arguments->target.out, "Run directory; only with one config");
  command
      ->add_option("--results", arguments->results,
                   "Where run directories are made: RESULTS/experiment/config")
      ->capture_default_str();
  AddSetFlag(*command, arguments->assignments);
  AddRunFlags(*command, arguments->target);
  command->footer("Example:\n  ariadne run experiments/configs/table_1.yaml --set repeats=9");
  command->callback([arguments, &status] {
    if (!arguments->target.out.empty() && arguments->configs.size() > 1) {
      Fail("--out names one run directory, but there are {} configs; use --results",
           arguments->configs.size());
    }
    for (const std::string& config : arguments->configs) {
      status = std::max(status, RunConfig(config, *arguments));
    }
  });
}

}  // namespace ariadne::experiments
