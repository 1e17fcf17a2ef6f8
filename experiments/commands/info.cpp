#include <fmt/format.h>

#include <memory>

#include "experiments/commands/commands.h"
#include "experiments/config/options_io.h"
#include "experiments/metrics/scan_statistics.h"
#include "experiments/report/table.h"
#include "experiments/run/progress_display.h"
#include "experiments/run/scan_source.h"

namespace ariadne::experiments {
namespace {

struct InfoArguments {
  std::string folder;
  std::string format = "auto";
  std::string poses;
};

std::string Describe(const Eigen::Vector3d& v) {
  return fmt::format("{:.1f} x {:.1f} x {:.1f}", v.x(), v.y(), v.z());
}

void PrintInfo(const InputOptions& input) {
  const ScanSource source(input);
  ProgressDisplay progress(false);
  Table table{{"scan", "points", "slices", "reflectance", "extent m", "range m (min median max)",
               "spacing cm", "suspicious"},
              {}};
  std::size_t points = 0;
  for (std::size_t i = 0; i < source.size(); ++i) {
    progress.Show(fmt::format("{} ({} of {})", source.name(i), i + 1, source.size()));
    const ScanStatistics s = MeasureScan(source.Read(i).cloud_laser);
    points += s.points;
    table.rows.push_back(
        {source.name(i), std::to_string(s.points), s.slices > 0 ? std::to_string(s.slices) : "-",
         s.has_reflectance ? "yes" : "no", Describe(s.extent),
         fmt::format("{:.2f} {:.2f} {:.2f}", s.min_range, s.median_range, s.max_range),
         fmt::format("{:.1f}", 100.0 * s.median_spacing), s.suspicious.empty() ? "-" : s.suspicious});
  }
  progress.Keep("");
  fmt::print("{} scans, {} points\n", source.size(), points);
  for (const std::string& note : source.notes()) fmt::print("{}\n", note);
  fmt::print("\n{}", ToText(table));
}

}  // namespace

void AddInfoCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand("info", "Tell what is in a folder of scans");
  auto arguments = std::make_shared<InfoArguments>();
  command->add_option("folder", arguments->folder, "Folder of scans, or builtin:office")->required();
  command->add_option("--format", arguments->format, "uos, xyz, ply, pcd or kitti; auto: by extension");
  command->add_option("--poses", arguments->poses, "File of first guesses of the poses");
  command->footer("Example:\n  ariadne info scans/hallway");
  command->callback([arguments] {
    OptionEntries entries;
    entries.Set("folder=" + arguments->folder);
    entries.Set("format=" + arguments->format);
    entries.Set("poses=" + arguments->poses);
    PrintInfo(ReadOptions<InputOptions>(entries));
  });
}

}  // namespace ariadne::experiments
