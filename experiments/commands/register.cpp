#include "experiments/studies/register.h"

#include <fmt/format.h>

#include "experiments/commands/commands.h"
#include "experiments/commands/run_target.h"
#include "experiments/config/options_io.h"
#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

struct RegisterArguments {
  std::string folder;
  std::string config;
  std::string format;
  std::string method;
  std::vector<std::string> assignments;
  RunTarget target;
};

/// The options of the config file, if any, changed by the command line.
RegisterOptions ResolveOptions(const RegisterArguments& arguments) {
  OptionEntries entries =
      arguments.config.empty() ? OptionEntries() : OptionEntries::FromFile(arguments.config);
  const std::optional<OptionEntry> experiment = entries.Take("experiment");
  if (experiment && experiment->value != "register") {
    Fail("{}: the experiment is {}, not register; use ariadne run", experiment->where, experiment->value);
  }
  if (!arguments.folder.empty()) entries.Set("input.folder=" + arguments.folder);
  if (!arguments.format.empty()) entries.Set("input.format=" + arguments.format);
  if (!arguments.method.empty()) entries.Set("registration.method=" + arguments.method);
  for (const std::string& assignment : arguments.assignments) entries.Set(assignment);
  return ReadOptions<RegisterOptions>(entries);
}

/// A resumed run has the options that it had before.
RegisterOptions ResumedOptions(const RegisterArguments& arguments) {
  if (!HoldsRun(arguments.target.out)) Fail("{}: there is no run to resume", arguments.target.out);
  RegisterArguments same;
  same.config = arguments.target.out + "/config.yaml";
  if (!arguments.folder.empty() || !arguments.config.empty() || !arguments.assignments.empty() ||
      !arguments.format.empty() || !arguments.method.empty()) {
    Fail("--resume takes the options of the run ({}); give only --out", same.config);
  }
  return ResolveOptions(same);
}

int Register(const RegisterArguments& arguments) {
  if (arguments.folder.empty() && arguments.config.empty() && !arguments.target.resume) {
    Fail("which scans? Give a folder: ariadne register DIR --out RUN (or --config FILE, or --resume)");
  }
  const RegisterOptions options =
      arguments.target.resume ? ResumedOptions(arguments) : ResolveOptions(arguments);
  const ScanSource check(options.input);  // what is wrong is told before anything is made or overwritten
  const RunDirectory run(arguments.target.out, arguments.target.existing());
  ProgressDisplay progress(arguments.target.quiet);
  const RegisterSummary summary = NotingFailure(run, [&] { return RunRegister(options, run, progress); });
  fmt::print("{}\n{}\n", ToText(summary.table), summary.residuals);
  if (!summary.errors.empty()) fmt::print("{}\n", summary.errors);
  fmt::print("results in {} (README.txt there says what is what)\n", run.path().string());
  if (summary.unregistered == 0) return 0;
  fmt::print(stderr, "ariadne: {}\n", summary.Problem());
  return 1;
}

}  // namespace

void AddRegisterCommand(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("register", "Register a folder of 3D scans into one map");
  auto arguments = std::make_shared<RegisterArguments>();
  command->add_option("folder", arguments->folder, "Folder of scans, or builtin:office");
  command->add_option("--format", arguments->format,
                      "uos, xyz, ply, pcd or kitti; without it: by extension");
  command->add_option("--method", arguments->method, "pairwise, metascan, simultaneous, graph or joint");
  command->add_option("--config", arguments->config, "YAML file of options");
  command->add_option("--out", arguments->target.out, "Run directory")->required();
  AddSetFlag(*command, arguments->assignments);
  AddRunFlags(*command, arguments->target);
  command->footer(
      "Example:\n"
      "  ariadne register scans/hallway --method simultaneous --set icp.max_distance=0.5 --out "
      "results/hallway\n"
      "Exit status: 0; 1 for an error, or if a scan could not be registered; 2 for wrong arguments.");
  command->callback([arguments, &status] { status = Register(*arguments); });
}

}  // namespace ariadne::experiments
