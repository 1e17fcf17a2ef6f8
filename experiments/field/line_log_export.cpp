#include "experiments/field/line_log_export.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <ostream>

#include "drivers/hardware/devices/line_telegrams.h"
#include "drivers/hardware/line_log.h"
#include "slam/base/error.h"
#include "slam/io/file.h"
#include "slam/io/trajectory.h"

namespace ariadne::experiments {
namespace {

using drivers::LineTelegram;
using drivers::LoggedRecord;

struct TimedAngle {
  double time = 0.0;
  double angle = 0.0;
};

/// Which device is on which line; those where nothing can be read are left out.
std::map<std::uint8_t, drivers::DeviceKind> DevicesOf(const std::filesystem::path& name) {
  std::map<std::uint8_t, drivers::DeviceGuess> guesses;
  drivers::VisitLineLog(name,
                        [&](const LoggedRecord& logged) { guesses[logged.line].Take(logged.record); });
  std::map<std::uint8_t, drivers::DeviceKind> devices;
  for (const auto& [line, guess] : guesses) {
    const drivers::DeviceGuess::Seen best = guess.Best();
    if (best.telegrams + best.sent > 0) devices[line] = best.kind;
  }
  return devices;
}

/// Shows all telegrams of a log in their order.
void VisitTelegrams(const std::filesystem::path& name,
                    const std::map<std::uint8_t, drivers::DeviceKind>& devices,
                    const std::function<void(std::uint8_t, const LineTelegram&)>& visit) {
  std::map<std::uint8_t, std::unique_ptr<drivers::TelegramReader>> readers;
  for (const auto& [line, kind] : devices) readers[line] = drivers::MakeTelegramReader(kind);
  drivers::VisitLineLog(name, [&](const LoggedRecord& logged) {
    const auto reader = readers.find(logged.line);
    if (reader == readers.end()) return;
    for (const LineTelegram& telegram : reader->second->Take(logged.record)) visit(logged.line, telegram);
  });
}

/// A log under export.
class LineLogExporter {
 public:
  LineLogExporter(const std::filesystem::path& name, const LineLogExportOptions& options)
      : name_(name), options_(options), devices_(DevicesOf(name)) {}

  std::size_t Telegrams(std::ostream& out) const;
  std::size_t Sweeps(std::ostream& out, bool points) const;
  std::size_t Counts(std::ostream& out) const;
  std::size_t Poses(std::ostream& out) const;

 private:
  std::vector<TimedAngle> Angles() const;
  double MiddleOf(const drivers::LineSweep& sweep, double arrived) const;

  const std::filesystem::path& name_;
  const LineLogExportOptions& options_;
  std::map<std::uint8_t, drivers::DeviceKind> devices_;
};

std::size_t LineLogExporter::Telegrams(std::ostream& out) const {
  std::size_t rows = 0;
  VisitTelegrams(name_, devices_, [&](std::uint8_t line, const LineTelegram& telegram) {
    out << fmt::format("{:.6f} {} {} {}{}\n", telegram.time, line, telegram.to_device ? '>' : '<',
                       telegram.bad ? "BAD " : "", telegram.text);
    ++rows;
  });
  return rows;
}

/// Of the servo, with the signs of its mount.
std::vector<TimedAngle> LineLogExporter::Angles() const {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  const double sign = options_.servo.reversed ? -1.0 : 1.0;
  std::vector<TimedAngle> angles;
  VisitTelegrams(name_, devices_, [&](std::uint8_t, const LineTelegram& telegram) {
    if (const auto* angle = std::get_if<drivers::LineAngle>(&telegram.value))
      angles.push_back({telegram.time, sign * (angle->turns - options_.servo.zero / 360.0) * kTurn});
  });
  return angles;
}

double LineLogExporter::MiddleOf(const drivers::LineSweep& sweep, double arrived) const {
  const double turns = std::max(1.0, std::round(std::numbers::pi / 180.0 / sweep.angle_step));
  return arrived - sweep.line_time - 0.5 * turns * options_.turn_period;
}

/// Between the readings of the servo; that of the nearest one beyond them; 0 without a servo.
double PitchAt(const std::vector<TimedAngle>& angles, double time) {
  if (angles.empty()) return 0.0;
  const auto after = std::ranges::lower_bound(angles, time, {}, &TimedAngle::time);
  if (after == angles.begin()) return angles.front().angle;
  if (after == angles.end()) return angles.back().angle;
  const TimedAngle& before = *(after - 1);
  const double span = after->time - before.time;
  const double share = span > 0.0 ? (time - before.time) / span : 0.0;
  return before.angle + share * (after->angle - before.angle);
}

void WritePoints(std::ostream& out, const drivers::LineSweep& sweep, double pitch, std::size_t& rows) {
  const slam::ScannerModel scanner{sweep.first_angle, sweep.angle_step};
  for (std::size_t beam = 0; beam < sweep.ranges.size(); ++beam) {
    if (std::isnan(sweep.ranges[beam])) continue;
    const Eigen::Vector3d p_laser = slam::BeamDirection(scanner, beam, pitch) * sweep.ranges[beam];
    out << fmt::format("{:.4f} {:.4f} {:.4f}\n", p_laser.x(), p_laser.y(), p_laser.z());
    ++rows;
  }
}

std::size_t LineLogExporter::Sweeps(std::ostream& out, bool points) const {
  const std::vector<TimedAngle> angles = Angles();
  std::size_t rows = 0;
  if (!points) out << "time,pitch,first_angle,angle_step,ranges\n";
  VisitTelegrams(name_, devices_, [&](std::uint8_t, const LineTelegram& telegram) {
    const auto* sweep = std::get_if<drivers::LineSweep>(&telegram.value);
    if (sweep == nullptr) return;
    const double time = MiddleOf(*sweep, telegram.time);
    const double pitch = PitchAt(angles, time);
    if (points) return WritePoints(out, *sweep, pitch, rows);
    out << fmt::format("{:.6f},{:.6f},{:.9g},{:.9g}", time, pitch, sweep->first_angle, sweep->angle_step);
    for (const float range : sweep->ranges)
      out << (std::isnan(range) ? std::string(",") : fmt::format(",{:.3f}", range));
    out << '\n';
    ++rows;
  });
  return rows;
}

std::size_t LineLogExporter::Counts(std::ostream& out) const {
  std::size_t rows = 0;
  out << "time,left,right\n";
  VisitTelegrams(name_, devices_, [&](std::uint8_t, const LineTelegram& telegram) {
    const auto* counts = std::get_if<drivers::LineCounts>(&telegram.value);
    if (counts == nullptr) return;
    const std::size_t left = options_.swap_motors ? 1 : 0;
    out << fmt::format("{:.6f},{},{}\n", telegram.time, counts->counts[left], counts->counts[1 - left]);
    ++rows;
  });
  return rows;
}

std::size_t LineLogExporter::Poses(std::ostream& out) const {
  control::WheelOdometry odometry(options_.wheels, {});
  std::vector<slam::StampedPose> poses;
  VisitTelegrams(name_, devices_, [&](std::uint8_t, const LineTelegram& telegram) {
    const auto* counts = std::get_if<drivers::LineCounts>(&telegram.value);
    if (counts == nullptr) return;
    const std::size_t left = options_.swap_motors ? 1 : 0;
    const control::WheelTicks ticks{static_cast<std::uint32_t>(counts->counts[left]),
                                    static_cast<std::uint32_t>(counts->counts[1 - left])};
    poses.push_back({telegram.time, slam::ToPose3(odometry.Update(ticks).T_odom_base)});
  });
  slam::WriteTum(out, poses);
  return poses.size();
}

std::string_view MissingText(LineLogFormat format) {
  if (format == LineLogFormat::kTelegrams) return "telegrams of a device that is known here";
  if (format == LineLogFormat::kSweeps || format == LineLogFormat::kXyz) return "sweeps of a scanner";
  return "readings of a motor board's encoders";
}

}  // namespace

LineLogExport ExportLineLog(const std::filesystem::path& name, LineLogFormat format,
                            const LineLogExportOptions& options, const std::filesystem::path& out) {
  CheckOptions(options, "");
  const LineLogExporter exporter(name, options);
  LineLogExport result;
  slam::WriteFileAtomically(out, [&](std::ostream& stream) {
    if (format == LineLogFormat::kTelegrams) result.rows = exporter.Telegrams(stream);
    if (format == LineLogFormat::kSweeps) result.rows = exporter.Sweeps(stream, false);
    if (format == LineLogFormat::kXyz) result.rows = exporter.Sweeps(stream, true);
    if (format == LineLogFormat::kOdometry) result.rows = exporter.Counts(stream);
    if (format == LineLogFormat::kTum) result.rows = exporter.Poses(stream);
    if (result.rows == 0) Fail("{}: holds no {}", name.string(), MissingText(format));
  });
  return result;
}

}  // namespace ariadne::experiments
