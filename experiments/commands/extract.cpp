#include "experiments/studies/extract.h"

#include <fmt/format.h>

#include <memory>

#include "experiments/commands/commands.h"
#include "experiments/commands/run_target.h"
#include "experiments/config/options_io.h"

namespace ariadne::experiments {
namespace {

struct ExtractArguments {
  std::string folder;
  std::string format = "auto";
  std::vector<std::string> assignments;
  RunTarget target;
};

void Extract(const ExtractArguments& arguments) {
  OptionEntries entries;
  entries.Set("input.folder=" + arguments.folder);
  entries.Set("input.format=" + arguments.format);
  for (const std::string& assignment : arguments.assignments) entries.Set(assignment);
  const auto options = ReadOptions<ExtractOptions>(entries);
  const ScanSource check(options.input);  // what is wrong is told before anything is made or overwritten
  const RunDirectory run(arguments.target.out, arguments.target.existing());
  run.WriteConfig("experiment: extract\n" + WriteOptions(options));
  ProgressDisplay progress(arguments.target.quiet);
  fmt::print("{}", NotingFailure(run, [&] { return RunExtract(options, run, progress); }));
  fmt::print("results in {}\n", run.path().string());
}

}  // namespace

void AddExtractCommand(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("extract", "Find lines, edge points, surfaces and objects in scans");
  auto arguments = std::make_shared<ExtractArguments>();
  command->add_option("folder", arguments->folder, "Folder of scans, builtin:office or builtin:tour")
      ->required();
  command->add_option("--format", arguments->format, "uos, xyz, ply, pcd or kitti; auto: by extension");
  command->add_option("--out", arguments->target.out, "Run directory")->required();
  AddSetFlag(*command, arguments->assignments);
  AddRunFlags(*command, arguments->target);
  command->footer(
      "Writes a drawing (.dxf), edge points (.ply) and a picture of each scan, and tables of all.\n"
      "Example:\n  ariadne extract scans/hallway --set surfaces.extract.lines.method=hough --out "
      "results/lines");
  command->callback([arguments] { Extract(*arguments); });
}

}  // namespace ariadne::experiments
