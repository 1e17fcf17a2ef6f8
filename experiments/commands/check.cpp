#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "experiments/commands/commands.h"
#include "experiments/commands/explore_config.h"
#include "experiments/commands/run_target.h"
#include "experiments/field/preflight.h"
#include "experiments/run/progress_display.h"

namespace ariadne::experiments {
namespace {

struct CheckArguments {
  std::string config;
  std::string out = "results";
  std::vector<std::string> assignments;
  bool quiet = false;
};

int PrintCheck(const CheckArguments& arguments) {
  const ExploreStudyOptions options = ResolveExploreOptions(arguments.config, arguments.assignments);
  ProgressDisplay progress(arguments.quiet);
  const std::vector<PreflightItem> items =
      CheckRobot(options.hardware, options.check, PortsOf(options.hardware),
                 AskSystem(arguments.out, arguments.config),
                 [&](const std::string& status) { progress.Show(status); });
  progress.Keep("");
  const auto red = std::ranges::count(items, false, &PreflightItem::ok);
  fmt::print("{}\n{}\n", ToText(items),
             red == 0 ? "all green" : fmt::format("{} of {} are red: do not drive", red, items.size()));
  return red == 0 ? 0 : 1;
}

}  // namespace

void AddCheckCommand(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand(
      "check", "Whether a robot on ports may leave: green, or a sentence for each thing");
  auto arguments = std::make_shared<CheckArguments>();
  command->add_option("config", arguments->config, "YAML file of the exploration")->required();
  command->add_option("--out", arguments->out, "Where the run is to go, for the room on its disk");
  AddSetFlag(*command, arguments->assignments);
  command->add_flag("-q,--quiet", arguments->quiet, "No progress on stderr");
  command->footer(
      "No wheel turns, but the scanner is tilted: keep hands away. Limits are the options check.*\n"
      "Example:\n"
      "  ariadne check experiments/configs/field_trial.yaml --set check.press_stop=20\n"
      "Exit status: 0 if all is green; 1 if anything is red; 2 for wrong arguments. See drivers/FIELD.md");
  command->callback([arguments, &status] { status = PrintCheck(*arguments); });
}

}  // namespace ariadne::experiments
