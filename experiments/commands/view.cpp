#include <fmt/format.h>
#include <spawn.h>

#include <array>
#include <cstdlib>
#include <memory>

#include "experiments/commands/commands.h"
#include "experiments/commands/run_target.h"
#include "experiments/config/options_io.h"
#include "experiments/render/png_file.h"
#include "experiments/run/run_directory.h"
#include "experiments/studies/view.h"
#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

struct ViewArguments {
  std::string target;
  std::string out;  // empty: the report of a run, view.png of a world
  bool no_open = false;
  std::vector<std::string> assignments;
};

bool HasDisplay() {
  const auto is_set = [](const char* name) {
    const char* value = std::getenv(name);
    return value != nullptr && *value != '\0';
  };
  return is_set("DISPLAY") || is_set("WAYLAND_DISPLAY");
}

/// Hands a file to the desktop, and does not wait for what shows it.
void OpenOnDesktop(std::string file) {
  std::string program = "xdg-open";
  const std::array<char*, 3> arguments{program.data(), file.data(), nullptr};
  pid_t process = 0;
  if (posix_spawnp(&process, program.c_str(), nullptr, nullptr, arguments.data(), environ) != 0)
    fmt::print("xdg-open is not installed: open this file in a browser\n");
}

void ShowReport(const ViewArguments& arguments) {
  if (!arguments.assignments.empty())
    Fail("--set says how to draw a picture, and needs --out; the report is seen in a browser");
  const std::filesystem::path report = std::filesystem::path(arguments.target) / "report.html";
  if (!std::filesystem::exists(report)) {
    Fail(
        "{}: there is no report.html, because the run has not finished; go on with --resume, or draw its "
        "map with --out FILE.png",
        arguments.target);
  }
  fmt::print("{}\n", report.string());
  if (HasDisplay() && !arguments.no_open) OpenOnDesktop(report.string());
}

void DrawView(const ViewArguments& arguments) {
  OptionEntries entries;
  for (const std::string& assignment : arguments.assignments) entries.Set(assignment);
  const auto options = ReadOptions<ViewOptions>(entries);
  const Image picture = HoldsRun(arguments.target) ? ViewRun(arguments.target, options)
                                                   : ViewWorld(arguments.target, options);
  const std::string out = arguments.out.empty() ? "view.png" : arguments.out;
  WritePng(out, picture);
  fmt::print("{}: {} x {} px\n", out, picture.width, picture.height);
}

void View(const ViewArguments& arguments) {
  if (arguments.out.empty() && HoldsRun(arguments.target)) {
    ShowReport(arguments);
  } else {
    DrawView(arguments);
  }
}

}  // namespace

void AddViewCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand("view", "Open the report of a run, or draw its map or a world");
  auto arguments = std::make_shared<ViewArguments>();
  command
      ->add_option("target", arguments->target,
                   "Run directory; or a world: builtin:robobench, .yaml, .json, mesh")
      ->required();
  command->add_option(
      "--out", arguments->out,
      "Picture to write (.png). Without it, a run's report is opened; a world goes to view.png");
  command->add_flag("--no-open", arguments->no_open, "Only print where the report is");
  AddSetFlag(*command, arguments->assignments);
  command->footer(
      "Options for --set: from=top|oblique|scanner, color=scan|height|reflectance|error, scan=N, "
      "width=PX,\n"
      "cut_height=M (worlds), geometry.plan.*, geometry.mesh.*\n"
      "Example:\n  ariadne view results/explore/demo\n"
      "  ariadne view results/explore/demo --set from=top --set color=scan --out map.png\n"
      "  ariadne view builtin:robobench --out robobench.png");
  command->callback([arguments] { View(*arguments); });
}

}  // namespace ariadne::experiments
