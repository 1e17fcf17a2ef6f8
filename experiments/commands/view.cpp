#include <fmt/format.h>

#include <memory>

#include "experiments/commands/commands.h"
#include "experiments/commands/run_target.h"
#include "experiments/config/options_io.h"
#include "experiments/render/png_file.h"
#include "experiments/run/run_directory.h"
#include "experiments/studies/view.h"

namespace ariadne::experiments {
namespace {

struct ViewArguments {
  std::string target;
  std::string out = "view.png";
  std::vector<std::string> assignments;
};

void View(const ViewArguments& arguments) {
  OptionEntries entries;
  for (const std::string& assignment : arguments.assignments) entries.Set(assignment);
  const auto options = ReadOptions<ViewOptions>(entries);
  const Image picture = HoldsRun(arguments.target) ? ViewRun(arguments.target, options)
                                                   : ViewWorld(arguments.target, options);
  WritePng(arguments.out, picture);
  fmt::print("{}: {} x {} px\n", arguments.out, picture.width, picture.height);
}

}  // namespace

void AddViewCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand("view", "Draw the map of a run, or a world, into a picture");
  auto arguments = std::make_shared<ViewArguments>();
  command
      ->add_option("target", arguments->target,
                   "Run directory; or a world: builtin:robobench, .yaml, .json, mesh")
      ->required();
  command->add_option("--out", arguments->out, "Picture to write (.png)")->capture_default_str();
  AddSetFlag(*command, arguments->assignments);
  command->footer(
      "Options for --set: from=top|oblique|scanner, color=scan|height|reflectance|error, scan=N, "
      "width=PX,\n"
      "cut_height=M (worlds), geometry.plan.*, geometry.mesh.*\n"
      "Example:\n  ariadne view results/register/demo --set from=top --set color=scan --out map.png\n"
      "  ariadne view builtin:robobench --out robobench.png");
  command->callback([arguments] { View(*arguments); });
}

}  // namespace ariadne::experiments
