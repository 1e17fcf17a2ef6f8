#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "experiments/commands/commands.h"
#include "experiments/commands/run_target.h"
#include "experiments/config/options_io.h"
#include "experiments/field/line_log_export.h"
#include "experiments/field/line_log_summary.h"

namespace ariadne::experiments {
namespace {

struct LogArguments {
  std::string path;
  std::string format;
  std::string out;
  std::vector<std::string> assignments;
};

void PrintLogInfo(const LogArguments& arguments) {
  bool first = true;
  for (const std::filesystem::path& name : drivers::FindLineLogs(arguments.path)) {
    fmt::print("{}{}", first ? "" : "\n", ToText(SummarizeLineLog(name)));
    first = false;
  }
}

std::string_view ExtensionOf(LineLogFormat format) {
  constexpr std::array<std::string_view, 5> kExtensions = {".telegrams.txt", ".sweeps.csv", ".xyz",
                                                           ".odometry.csv", ".tum"};
  return kExtensions[static_cast<std::size_t>(format)];
}

void ExportLog(const LogArguments& arguments) {
  OptionEntries entries;
  for (const std::string& assignment : arguments.assignments) entries.Set(assignment);
  const auto options = ReadOptions<LineLogExportOptions>(entries);
  constexpr auto& kNames = EnumNames<LineLogFormat>::value;
  const auto format =
      static_cast<LineLogFormat>(std::ranges::find(kNames, arguments.format) - kNames.begin());
  const std::vector<std::filesystem::path> names = drivers::FindLineLogs(arguments.path);
  if (names.size() > 1 && !arguments.out.empty())
    Fail("{}: holds {} logs, but --out names one file", arguments.path, names.size());
  for (const std::filesystem::path& name : names) {
    const std::string out =
        arguments.out.empty() ? fmt::format("{}{}", name.string(), ExtensionOf(format)) : arguments.out;
    const LineLogExport result = ExportLineLog(name, format, options, out);
    fmt::print("{}: {} {}\n", out, result.rows,
               format == LineLogFormat::kTelegrams ? "telegrams"
               : format == LineLogFormat::kSweeps  ? "sweeps"
               : format == LineLogFormat::kXyz     ? "points"
                                                   : "readings");
  }
}

void AddLogInfo(CLI::App& command) {
  auto arguments = std::make_shared<LogArguments>();
  CLI::App* info = command.add_subcommand("info", "Tell what is in a log: times, bytes, telegrams, errors");
  info->add_option("log", arguments->path, "NAME of a log, one of its files, or a folder")->required();
  info->footer("Example:\n  ariadne log info results/first/lines");
  info->callback([arguments] { PrintLogInfo(*arguments); });
}

void AddLogExport(CLI::App& command) {
  auto arguments = std::make_shared<LogArguments>();
  CLI::App* to = command.add_subcommand("export", "Write what a log holds for people and other programs");
  to->add_option("log", arguments->path, "NAME of a log, one of its files, or a folder")->required();
  to->add_option("--to", arguments->format, "telegrams, sweeps, xyz, odometry or tum")
      ->required()
      ->check(CLI::IsMember(std::vector<std::string>(EnumNames<LineLogFormat>::value.begin(),
                                                     EnumNames<LineLogFormat>::value.end())));
  to->add_option("--out", arguments->out, "File to write; without it: beside the log");
  AddSetFlag(*to, arguments->assignments);
  to->footer(
      "telegrams  text: time, line, > to the device or < from it, what it says\n"
      "sweeps     CSV: time, pitch, first angle, step, ranges\n"
      "xyz        points in the frame of the laser, turned by the servo's angle\n"
      "odometry   CSV: time, counts of the left and the right wheel\n"
      "tum        the poses that follow from them, by wheels.*\n"
      "Example:\n"
      "  ariadne log export results/first/lines --to xyz --set servo.zero=181.5 --out sweeps.xyz");
  to->callback([arguments] { ExportLog(*arguments); });
}

}  // namespace

void AddLogCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand("log", "Look into the log of what crossed the lines to devices");
  command->require_subcommand(1);
  AddLogInfo(*command);
  AddLogExport(*command);
  command->footer(
      "Example:\n"
      "  ariadne log info results/first/lines\n"
      "  ariadne log export results/first/lines --to telegrams\n"
      "ariadne log info --help tells more.");
}

}  // namespace ariadne::experiments
