#include "experiments/field/calibrate.h"

#include <fmt/format.h>

#include <memory>

#include "experiments/commands/commands.h"
#include "experiments/commands/run_target.h"
#include "experiments/config/options_io.h"

namespace ariadne::experiments {
namespace {

struct CalibrateArguments {
  std::vector<std::string> inputs;
  std::vector<std::string> assignments;
};

template <typename Options>
Options OptionsOf(const CalibrateArguments& arguments) {
  OptionEntries entries;
  for (const std::string& assignment : arguments.assignments) entries.Set(assignment);
  return ReadOptions<Options>(entries);
}

void AddCalibrateScanner(CLI::App& command) {
  auto arguments = std::make_shared<CalibrateArguments>();
  CLI::App* scanner =
      command.add_subcommand("scanner", "How the scanner sits, from scans of a floor and walls");
  scanner->add_option("runs", arguments->inputs, "Run directories of ariadne explore, or their robot.log")
      ->required();
  AddSetFlag(*scanner, arguments->assignments);
  scanner->footer(
      "Scan standing on an even floor, with a wall ahead and walls beside, in two or three places.\n"
      "Example:\n"
      "  ariadne calibrate scanner results/first --set mount.z=0.62 --set scans=3");
  scanner->callback([arguments] {
    fmt::print("{}",
               CalibrateScannerText(arguments->inputs, OptionsOf<CalibrateScannerRunOptions>(*arguments)));
  });
}

void AddCalibrateWheels(CLI::App& command) {
  auto arguments = std::make_shared<CalibrateArguments>();
  CLI::App* wheels =
      command.add_subcommand("wheels", "The ratio of the wheels and their track, from driven squares");
  wheels->add_option("squares", arguments->inputs, "File: a line per square, ccw or cw, x and y")
      ->required()
      ->expected(1);
  AddSetFlag(*wheels, arguments->assignments);
  wheels->footer(
      "UMBmark: from a marked start, drive a square of 4 m by odometry alone, five times to the left\n"
      "(ccw) and five times to the right (cw). Each time measure where the robot stands, less where it\n"
      "takes itself to be; x is ahead and y to the left as it started. In the file: ccw 0.031 -0.120\n"
      "Example:\n"
      "  ariadne calibrate wheels squares.txt --set drive.track=0.38 --set squares.side=4");
  wheels->callback([arguments] {
    fmt::print("{}", CalibrateWheelsText(arguments->inputs.front(),
                                         OptionsOf<CalibrateWheelsFileOptions>(*arguments)));
  });
}

}  // namespace

void AddCalibrateCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand("calibrate", "How the scanner sits, and what the wheels are");
  command->require_subcommand(1);
  AddCalibrateScanner(*command);
  AddCalibrateWheels(*command);
  command->footer(
      "Example:\n"
      "  ariadne calibrate scanner results/first --set mount.z=0.62\n"
      "  ariadne calibrate wheels squares.txt --set drive.track=0.38\n"
      "What cannot be told, or is not plausible, is refused with a sentence. See drivers/FIELD.md");
}

}  // namespace ariadne::experiments
