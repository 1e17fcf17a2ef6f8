#include "experiments/studies/simulate.h"

#include <fmt/format.h>

#include <memory>

#include "experiments/commands/commands.h"
#include "experiments/commands/run_target.h"
#include "experiments/config/options_io.h"

namespace ariadne::experiments {
namespace {

struct SimulateArguments {
  std::string world;
  std::string waypoints;
  std::vector<std::string> assignments;
  RunTarget target;
};

void Simulate(const SimulateArguments& arguments) {
  OptionEntries entries;
  if (!arguments.world.empty()) entries.Set("input.tour.world=" + arguments.world);
  if (!arguments.waypoints.empty()) entries.Set("input.tour.waypoints=" + arguments.waypoints);
  for (const std::string& assignment : arguments.assignments) entries.Set(assignment);
  const auto options = ReadOptions<SimulateOptions>(entries);
  const ScanSource check(options.input);  // what is wrong is told before anything is made or overwritten
  const RunDirectory run(arguments.target.out, arguments.target.existing());
  run.WriteConfig("experiment: simulate\n" + WriteOptions(options));
  ProgressDisplay progress(arguments.target.quiet);
  fmt::print("{}", NotingFailure(run, [&] { return RunSimulate(options, run, progress); }));
}

}  // namespace

void AddSimulateCommand(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("simulate", "Let a simulated robot scan a world, and write its scans");
  auto arguments = std::make_shared<SimulateArguments>();
  command->add_option("world", arguments->world,
                      "builtin:robobench, builtin:entrance_hall, .yaml, .json (floor plan) or a mesh");
  command->add_option("--waypoints", arguments->waypoints,
                      "Of the robot's way: \"x y, x y, ...\" in metres");
  command->add_option("--out", arguments->target.out, "Directory for scans, odometry and truth")
      ->required();
  AddSetFlag(*command, arguments->assignments);
  AddRunFlags(*command, arguments->target);
  command->footer(
      "Example:\n  ariadne simulate builtin:robobench --set input.tour.odometry_noise=2 --set format=ply "
      "--out data\n"
      "  ariadne register data/scans --out results/simulated");
  command->callback([arguments] { Simulate(*arguments); });
}

}  // namespace ariadne::experiments
