#include "experiments/studies/explore.h"

#include <fmt/format.h>

#include <csignal>
#include <memory>

#include "experiments/commands/commands.h"
#include "experiments/commands/run_target.h"
#include "experiments/config/options_io.h"
#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

volatile std::sig_atomic_t stop_requested = 0;  // latches: only a new start of the program goes on

extern "C" void RequestStop(int) { stop_requested = 1; }

/// The first signal stops the wheels and ends the mission in order; a second one ends the program at once.
void StopOnSignals() {
  struct sigaction action = {};
  action.sa_handler = RequestStop;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaction(signal, &action, nullptr);
}

struct ExploreArguments {
  std::string config;
  std::vector<std::string> assignments;
  RunTarget target;
};

ExploreStudyOptions ResolveExploreOptions(const ExploreArguments& arguments, const std::string& config) {
  OptionEntries entries = config.empty() ? OptionEntries() : OptionEntries::FromFile(config);
  const std::optional<OptionEntry> experiment = entries.Take("experiment");
  if (experiment && experiment->value != "explore")
    Fail("{}: the experiment is {}, not explore; use ariadne run", experiment->where, experiment->value);
  for (const std::string& assignment : arguments.assignments) entries.Set(assignment);
  if (const std::optional<OptionEntry> kind = entries.Take("robot"))
    entries.Set("robot.kind=" + kind->value);
  return ReadOptions<ExploreStudyOptions>(entries);
}

int Explore(const ExploreArguments& arguments) {
  if (arguments.target.resume && (!arguments.config.empty() || !arguments.assignments.empty()))
    Fail("--resume takes the options of the run ({}/config.yaml); give only --out", arguments.target.out);
  const std::string config =
      arguments.target.resume ? arguments.target.out + "/config.yaml" : arguments.config;
  const ExploreStudyOptions options = ResolveExploreOptions(arguments, config);
  CheckExplore(options);
  const RunDirectory run(arguments.target.out, arguments.target.existing());
  run.WriteConfig("experiment: explore\n" + WriteOptions(options));
  ProgressDisplay progress(arguments.target.quiet);
  StopOnSignals();
  const auto stop = [] { return stop_requested != 0; };
  fmt::print("{}", NotingFailure(run, [&] { return RunExplore(options, run, progress, stop); }));
  fmt::print("results in {}\n", run.path().string());
  if (!stop()) fmt::print("open {}/report.html in a browser\n", run.path().string());
  return stop() ? 1 : 0;
}

}  // namespace

void AddExploreCommand(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand(
      "explore", "Explore a building that the robot was never told, until nothing is left to see");
  auto arguments = std::make_shared<ExploreArguments>();
  command->add_option("config", arguments->config, "YAML file of options; without one: the defaults");
  command->add_option("--out", arguments->target.out, "Run directory")->required();
  AddSetFlag(*command, arguments->assignments);
  AddRunFlags(*command, arguments->target);
  command->footer(
      "Example:\n"
      "  ariadne explore experiments/configs/explore_robobench.yaml --out results/robobench\n"
      "  ariadne explore --resume --out results/robobench      # after a kill: goes on where it was\n"
      "Ctrl-C stops the wheels and ends the mission in order.\n"
      "Exit status: 0; 1 for an error, or if the mission was stopped; 2 for wrong arguments.");
  command->callback([arguments, &status] { status = Explore(*arguments); });
}

}  // namespace ariadne::experiments
