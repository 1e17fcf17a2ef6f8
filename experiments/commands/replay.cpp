#include <fmt/format.h>

#include <memory>

#include "experiments/commands/commands.h"
#include "experiments/commands/explore_config.h"
#include "experiments/commands/run_target.h"
#include "experiments/studies/replayed_exploration.h"

namespace ariadne::experiments {
namespace {

struct ReplayArguments {
  std::string log;
  std::vector<std::string> assignments;
  bool quiet = false;
};

std::string TextOf(const RecordedStart& start, const ReplayResult& result) {
  const std::string what = fmt::format(
      "{}: {} scans, {} calls of the mission, {} calls to the lines, to {:.3f} s of their clock: ",
      start.log.string(), result.stops, result.robot_calls, result.line_calls, result.time);
  if (!result.departure.empty()) return what + "all the same, and then NOT\n" + result.departure + "\n";
  return what + "all the same\n" + result.end + "\n";
}

int ReplayLogs(const ReplayArguments& arguments) {
  ProgressDisplay progress(arguments.quiet);
  bool same = true;
  for (const RecordedStart& start : FindRecordedStarts(arguments.log)) {
    const ExploreStudyOptions options =
        ResolveExploreOptions((start.run / "config.yaml").string(), arguments.assignments);
    const ReplayResult result = ReplayExploration(start, options, progress);
    progress.Keep("");
    fmt::print("{}", TextOf(start, result));
    same = same && result.departure.empty();
  }
  return same ? 0 : 1;
}

}  // namespace

void AddReplayCommand(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand(
      "replay",
      "Run drivers and mission once more on the lines of a run, and see whether they do the same");
  auto arguments = std::make_shared<ReplayArguments>();
  command
      ->add_option("log", arguments->log,
                   "Directory of a run of `explore` with a robot of devices, or one of its logs of lines")
      ->required();
  AddSetFlag(*command, arguments->assignments);
  command->add_flag("-q,--quiet", arguments->quiet, "No progress on stderr");
  command->footer(
      "Options are those of the run's config.yaml; --set asks what others would have decided.\n"
      "Example:\n"
      "  ariadne replay results/trial\n"
      "  ariadne replay results/trial/lines-2.log --set mission.planner.min_opening=0.5\n"
      "Exit status: 0 if all was done and decided as it was; 1 for an error, or if anything differs, "
      "which\n"
      "is printed with what was recorded; 2 for wrong arguments.");
  command->callback([arguments, &status] { status = ReplayLogs(*arguments); });
}

}  // namespace ariadne::experiments
