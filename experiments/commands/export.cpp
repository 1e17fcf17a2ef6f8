#include "experiments/studies/export.h"

#include <fmt/format.h>

#include <memory>

#include "experiments/commands/commands.h"
#include "experiments/commands/run_target.h"
#include "experiments/config/options_io.h"
#include "experiments/run/progress_display.h"

namespace ariadne::experiments {
namespace {

struct ExportArguments {
  std::string run;
  std::string format;
  std::string part;
  std::string out;
  std::vector<std::string> assignments;
};

ExportPart PartOf(const ExportArguments& arguments, slam::ExportFormat format) {
  if (arguments.part.empty()) return UsualPart(format);
  constexpr auto& kNames = EnumNames<ExportPart>::value;
  return static_cast<ExportPart>(std::ranges::find(kNames, arguments.part) - kNames.begin());
}

void Export(const ExportArguments& arguments) {
  OptionEntries entries;
  for (const std::string& assignment : arguments.assignments) entries.Set(assignment);
  const auto options = ReadOptions<ModelOptions>(entries);
  const slam::ExportFormat format = slam::ExportFormatFromName(arguments.format);
  const ExportPart part = PartOf(arguments, format);
  const std::string file = arguments.out.empty() ? fmt::format("{}/{}{}", arguments.run, NameOf(part),
                                                               slam::InfoOf(format).extension)
                                                 : arguments.out;
  ProgressDisplay progress(false);
  ExportRun(arguments.run, format, part, options, file,
            [&](const std::string& step, std::size_t done, std::size_t total) {
              progress.Show(fmt::format("{}: scan {} of {}", step, done + 1, total));
            });
  progress.Keep("");
  fmt::print("{}: {} bytes\n", file, std::filesystem::file_size(file));
}

/// A line per format.
std::string FormatHelp() {
  std::string text = "Formats:\n";
  for (const slam::ExportFormatInfo& info : slam::ExportFormats())
    text += fmt::format("  {:5} {}\n", info.name, info.description);
  return text;
}

}  // namespace

void AddExportCommand(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("export", "Write the model of a registered run for other programs");
  auto arguments = std::make_shared<ExportArguments>();
  command->add_option("run", arguments->run, "Run directory of ariadne register")->required();
  command->add_option("--to", arguments->format, "dxf, svg, vrml, ply, glb, bt, ot or pgm")->required();
  command
      ->add_option("--part", arguments->part,
                   "model, plan, mesh, voxels or grid; without it: the usual one")
      ->check(CLI::IsMember(std::vector<std::string>(EnumNames<ExportPart>::value.begin(),
                                                     EnumNames<ExportPart>::value.end())));
  command->add_option("--out", arguments->out, "File to write; without it: into the run directory");
  AddSetFlag(*command, arguments->assignments);
  command->footer(
      FormatHelp() +
      "Options for --set are those of ariadne map (ariadne config --describe map).\n"
      "Example:\n  ariadne export results/garage --to svg --set plan_heights=1.2 --out plan.svg");
  command->callback([arguments] { Export(*arguments); });
}

}  // namespace ariadne::experiments
