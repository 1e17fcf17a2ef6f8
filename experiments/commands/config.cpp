#include <fmt/format.h>

#include <memory>

#include "experiments/commands/commands.h"
#include "experiments/commands/run_target.h"
#include "experiments/studies/catalog.h"

namespace ariadne::experiments {
namespace {

struct ConfigArguments {
  std::string experiment = "register";
  bool describe = false;
};

void PrintManual(const Study& study) {
  fmt::print("Options of the experiment {}: {}\n\n", study.name, study.summary);
  for (const OptionDescription& option : study.describe()) {
    fmt::print("{} = {}{}{}\n    {}\n    {}\n", option.key, option.value.empty() ? "''" : option.value,
               option.unit.empty() ? "" : " ", option.unit, option.range, option.reason);
  }
}

}  // namespace

void AddConfigCommand(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("config", "Print the options of an experiment, as YAML or as a manual");
  auto arguments = std::make_shared<ConfigArguments>();
  command->add_option("experiment", arguments->experiment, "Its name")->capture_default_str();
  command->add_flag("--describe", arguments->describe, "The manual: key, default, unit, range, source");
  command->footer("Example:\n  ariadne config register --describe\n  ariadne config register > my.yaml");
  command->callback([arguments] {
    const Study& study = FindStudy(arguments->experiment);
    if (arguments->describe) {
      PrintManual(study);
    } else {
      fmt::print("{}", study.defaults());
    }
  });
}

}  // namespace ariadne::experiments
