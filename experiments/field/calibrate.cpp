#include "experiments/field/calibrate.h"

#include <fmt/format.h>

#include <algorithm>
#include <istream>
#include <sstream>

#include "drivers/replay/robot_log.h"
#include "experiments/report/table.h"
#include "slam/base/error.h"
#include "slam/io/file.h"

namespace ariadne::experiments {
namespace {

std::string MountingTable(const drivers::ScannerCalibration& found) {
  const auto angle = [](double value) { return fmt::format("{:.3f} deg", slam::DegFromRad(value)); };
  const auto length = [](double value) { return fmt::format("{:.1f} mm", 1000.0 * value); };
  const auto sigma = [&](int i) { return std::sqrt(found.covariance(i, i)); };
  const drivers::ScannerMounting& m = found.mounting;
  Table table{{"", "found", "sigma"}, {}};
  table.rows = {{"roll", angle(m.roll), angle(sigma(0))},
                {"pitch", angle(m.pitch), angle(sigma(1))},
                {"height of the tilt axis", length(m.height), length(sigma(2))},
                {"mirror ahead of the axis", length(m.mirror_forward), length(sigma(3))},
                {"mirror above the axis", length(m.mirror_up), length(sigma(4))},
                {"missing in ranges", length(m.range_offset), length(sigma(5))}};
  return ToText(table);
}

drivers::DrivenSquare SquareIn(std::string line, const std::string& where) {
  std::ranges::replace(line, ',', ' ');
  std::istringstream words(line);
  std::string direction, rest;
  drivers::DrivenSquare square;
  if (!(words >> direction >> square.error.x() >> square.error.y()) || (words >> rest) ||
      (direction != "cw" && direction != "ccw") || !square.error.allFinite()) {
    Fail("{}: expected cw or ccw and the error in x and y in metres, such as: ccw 0.031 -0.120", where);
  }
  square.counterclockwise = direction == "ccw";
  return square;
}

}  // namespace

std::vector<slam::Scan> ReadLoggedScans(const std::filesystem::path& run, int count) {
  const std::filesystem::path path = std::filesystem::is_directory(run) ? run / "robot.log" : run;
  drivers::RobotLog log = drivers::ReadRobotLog(path);
  std::vector<slam::Scan> scans;
  for (std::size_t i = 0; i < log.size() && scans.size() < static_cast<std::size_t>(count); ++i) {
    if (log.KindAt(i) == drivers::CallKind::kScan)
      scans.push_back(std::get<drivers::ScanCall>(log.Read(i)).scan);
  }
  if (scans.empty()) Fail("{}: holds no scans", path.string());
  return scans;
}

std::vector<drivers::DrivenSquare> ReadSquares(std::istream& in, const std::string& name) {
  std::vector<drivers::DrivenSquare> squares;
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    line = line.substr(0, line.find('#'));
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    squares.push_back(SquareIn(line, fmt::format("{}:{}", name, number)));
  }
  return squares;
}

std::string CalibrateScannerText(const std::vector<std::string>& runs,
                                 const CalibrateScannerRunOptions& options) {
  CheckOptions(options, "");
  std::vector<slam::Scan> scans;
  for (const std::string& run : runs) {
    for (slam::Scan& scan : ReadLoggedScans(run, options.scans)) scans.push_back(std::move(scan));
  }
  const drivers::ScannerMounting guess{
      options.mount.roll, options.mount.pitch, options.mount.z, 0.0, 0.0, 0.0};
  const drivers::ScannerCalibration found = drivers::CalibrateScanner(scans, guess, options.scanner);
  std::string text = MountingTable(found);
  text += fmt::format(
      "\nfrom {} points of {} scans on {} floors, {} walls and {} ceilings, {:.1f} mm off these\n",
      found.points, scans.size(), found.floors, found.walls, found.ceilings, 1000.0 * found.rms);
  text +=
      "The mirror should stand on the axis, and nothing be missing in ranges: scans take them so; shift "
      "the\n"
      "scanner in its mount where they are off by more than their sigma matters.\n";
  text += fmt::format("\nhardware:\n  mount:\n    roll: {:.6f}\n    pitch: {:.6f}\n    z: {:.5f}\n",
                      found.mounting.roll, found.mounting.pitch, found.mounting.height);
  return text;
}

std::string CalibrateWheelsText(const std::string& file, const CalibrateWheelsFileOptions& options) {
  CheckOptions(options, "");
  const std::vector<drivers::DrivenSquare> squares = slam::ReadFile(file, ReadSquares);
  const drivers::WheelCalibration found = drivers::CalibrateWheels(squares, options.drive, options.squares);
  Table table{{"", "was", "found", "sigma"}, {}};
  table.rows = {
      {"right radius / left radius", fmt::format("{:.5f}", options.drive.radius_ratio),
       fmt::format("{:.5f}", found.geometry.radius_ratio),
       fmt::format("{:.5f}", options.drive.radius_ratio * std::sqrt(found.covariance(0, 0)))},
      {"track m", fmt::format("{:.5f}", options.drive.track), fmt::format("{:.5f}", found.geometry.track),
       fmt::format("{:.5f}", options.drive.track * std::sqrt(found.covariance(1, 1)))}};
  return fmt::format(
      "{}\n{} squares of {} m: mean error {:.3f} m, with the new values {:.3f} m; one square scatters by "
      "{:.3f} m\nThe wheels' mean radius is told by a straight way and a tape, not by squares.\n\n"
      "hardware:\n  drive:\n    radius_ratio: {:.6f}\n    track: {:.6f}\n",
      ToText(table), squares.size(), options.squares.side, found.error_before, found.error_after,
      found.scatter, found.geometry.radius_ratio, found.geometry.track);
}

}  // namespace ariadne::experiments
