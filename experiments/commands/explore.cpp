#include "experiments/studies/explore.h"

#include <fmt/format.h>

#include <csignal>
#include <cstdio>
#include <functional>
#include <memory>
#include <optional>

#include "experiments/commands/commands.h"
#include "experiments/commands/explore_config.h"
#include "experiments/commands/run_target.h"
#include "experiments/config/options_io.h"
#include "experiments/field/terminal.h"
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
  bool approve = false;
};

/// Who is asked before each drive, and can stop it with any key.
class Approver {
 public:
  /// A key, the end of the terminal, or a signal: the wheels stop, and the mission ends; see --resume.
  bool MustStop() { return stop_requested != 0 || !terminal_.StopReason().empty() || called_off_; }

  /// False ends the mission.
  bool Approves(const PlannedDrive& drive) {
    fmt::print("{}\n  one key: y drives (then any key stops), n ends the mission here, q stops now\n",
               PlanText(drive));
    std::fflush(stdout);
    const std::optional<char> key = terminal_.Ask("ynq", [] { return stop_requested != 0; });
    called_off_ = !key || key == 'q';
    return key == 'y';
  }

 private:
  static std::string PlanText(const PlannedDrive& drive) {
    double length = 0.0;
    for (std::size_t i = 1; i < drive.path_map.size(); ++i)
      length += (drive.path_map[i].translation - drive.path_map[i - 1].translation).norm();
    const std::string to = drive.view
                               ? fmt::format("to the view at ({:.2f}, {:.2f}) m, {} rays of gain",
                                             drive.view->p_map.x(), drive.view->p_map.y(), drive.view->gain)
                               : std::string("back to where the robot was");
    const slam::Pose2 end = drive.path_map.empty() ? slam::Pose2() : drive.path_map.back();
    return fmt::format("plan: {:.1f} m {}{}, ending at ({:.2f}, {:.2f}) m", length, to,
                       drive.leg_only ? ", a part of the way" : "", end.translation.x(),
                       end.translation.y());
  }

  Terminal terminal_;
  bool called_off_ = false;
};

int Explore(const ExploreArguments& arguments) {
  if (arguments.target.resume && (!arguments.config.empty() || !arguments.assignments.empty()))
    Fail("--resume takes the options of the run ({}/config.yaml); give only --out", arguments.target.out);
  const std::string config =
      arguments.target.resume ? arguments.target.out + "/config.yaml" : arguments.config;
  ExploreStudyOptions options = ResolveExploreOptions(config, arguments.assignments);
  options.approve = options.approve || arguments.approve;
  CheckExplore(options);
  const RunDirectory run(arguments.target.out, arguments.target.existing());
  run.WriteConfig("experiment: explore\n" + WriteOptions(options));
  ProgressDisplay progress(arguments.target.quiet);
  StopOnSignals();
  std::optional<Approver> approver;
  if (options.approve) approver.emplace();
  const auto stop = [&] { return approver ? approver->MustStop() : stop_requested != 0; };
  std::function<bool(const PlannedDrive&)> approve;
  if (approver) approve = [&](const PlannedDrive& drive) { return approver->Approves(drive); };
  fmt::print("{}", NotingFailure(run, [&] { return RunExplore(options, run, progress, stop, approve); }));
  fmt::print("results in {}\n", run.path().string());
  if (!stop()) fmt::print("open {}/report.html in a browser\n", run.path().string());
  return stop() ? 1 : 0;
}

}  // namespace

ExploreStudyOptions ResolveExploreOptions(const std::string& config,
                                          const std::vector<std::string>& assignments) {
  OptionEntries entries = config.empty() ? OptionEntries() : OptionEntries::FromFile(config);
  const std::optional<OptionEntry> experiment = entries.Take("experiment");
  if (experiment && experiment->value != "explore")
    Fail("{}: the experiment is {}, not explore; use ariadne run", experiment->where, experiment->value);
  for (const std::string& assignment : assignments) entries.Set(assignment);
  if (const std::optional<OptionEntry> kind = entries.Take("robot"))
    entries.Set("robot.kind=" + kind->value);
  return ReadOptions<ExploreStudyOptions>(entries);
}

void AddExploreCommand(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand(
      "explore", "Explore a building that the robot was never told, until nothing is left to see");
  auto arguments = std::make_shared<ExploreArguments>();
  command->add_option("config", arguments->config, "YAML file of options; without one: the defaults");
  command->add_option("--out", arguments->target.out, "Run directory")->required();
  AddSetFlag(*command, arguments->assignments);
  AddRunFlags(*command, arguments->target);
  command->add_flag("--approve", arguments->approve,
                    "Ask before each drive: y, n or q; any key while driving, or a lost terminal, stops");
  command->footer(
      "Example:\n"
      "  ariadne explore experiments/configs/explore_robobench.yaml --out results/robobench\n"
      "  ariadne explore --resume --out results/robobench      # after a kill: goes on where it was\n"
      "Ctrl-C stops the wheels and ends the mission in order.\n"
      "Exit status: 0; 1 for an error, or if the mission was stopped; 2 for wrong arguments.");
  command->callback([arguments, &status] { status = Explore(*arguments); });
}

}  // namespace ariadne::experiments
