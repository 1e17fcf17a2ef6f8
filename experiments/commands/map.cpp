#include "experiments/studies/map.h"

#include <fmt/format.h>

#include <memory>

#include "experiments/commands/commands.h"
#include "experiments/commands/run_target.h"
#include "experiments/config/options_io.h"

namespace ariadne::experiments {
namespace {

struct MapArguments {
  std::string run;
  std::vector<std::string> assignments;
  RunTarget target;
};

void Map(const MapArguments& arguments) {
  OptionEntries entries;
  entries.Set("run=" + arguments.run);
  for (const std::string& assignment : arguments.assignments) entries.Set(assignment);
  const auto options = ReadOptions<MapStudyOptions>(entries);
  CheckMapInput(options);
  const std::string out = arguments.target.out.empty() ? arguments.run + "/model" : arguments.target.out;
  const RunDirectory run(out, arguments.target.existing());
  run.WriteConfig("experiment: map\n" + WriteOptions(options));
  ProgressDisplay progress(arguments.target.quiet);
  fmt::print("{}", NotingFailure(run, [&] { return RunMap(options, run, progress); }));
  fmt::print("results in {} (README.txt there says what is what)\n", run.path().string());
}

}  // namespace

void AddMapCommand(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("map", "Make a model of a registered run: surfaces, voxels, meshes, plans, grids");
  auto arguments = std::make_shared<MapArguments>();
  command->add_option("run", arguments->run, "Run directory of ariadne register")->required();
  command->add_option("--out", arguments->target.out, "Directory of the model; without it: RUN/model");
  AddSetFlag(*command, arguments->assignments);
  AddRunFlags(*command, arguments->target);
  command->footer(
      "Example:\n  ariadne map results/garage --set octree.leaf_size=0.1\n"
      "where results/garage is what `ariadne register scans/garage13 --out results/garage` has left.");
  command->callback([arguments] { Map(*arguments); });
}

}  // namespace ariadne::experiments
