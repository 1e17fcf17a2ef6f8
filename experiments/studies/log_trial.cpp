#include <algorithm>
#include <cmath>
#include <optional>

#include "experiments/studies/feature_trials.h"
#include "slam/base/stopwatch.h"
#include "slam/extract/slice_points.h"
#include "slam/geometry/angles.h"
#include "slam/io/carmen.h"
#include "slam/io/file.h"

namespace ariadne::experiments {
namespace {

constexpr double kLong = 0.5;  // of lines that count [m]
const double kSameAngle = slam::RadFromDeg(5.0);
constexpr double kSameOffset = 0.05;  // [m]

using Lines = std::vector<slam::LineSegment>;

/// A line as the next sweep would see it.
struct MovedLine {
  Eigen::Vector2d middle;  // [m]
  double angle = 0.0;      // of the normal [rad]
};

MovedLine Moved(const slam::LineSegment& line, const slam::Pose2& T_next_this) {
  return {T_next_this * Eigen::Vector2d(0.5 * (line.from + line.to)),
          slam::WrapAngle(line.angle + T_next_this.angle)};
}

/// Whether the next scanner, which looks 180 deg ahead, has the middle of the line well in its view.
bool IsInView(const MovedLine& line) {
  return std::abs(std::atan2(line.middle.y(), line.middle.x())) < slam::RadFromDeg(80.0);
}

/// The line of the next sweep that goes through the middle of this one in its direction.
const slam::LineSegment* Again(const MovedLine& line, const Lines& next) {
  const auto found = std::ranges::find_if(next, [&](const slam::LineSegment& other) {
    const Eigen::Vector2d along = (other.to - other.from).normalized();
    const double at = along.dot(line.middle - other.from);
    return std::abs(slam::WrapAngle(other.angle - line.angle)) < kSameAngle &&
           std::abs(other.Distance(line.middle)) < kSameOffset && at > 0.0 && at < other.Length();
  });
  return found == next.end() ? nullptr : &*found;
}

void Add(LogTrial& trial, const Lines& lines, std::size_t points) {
  ++trial.sweeps;
  trial.points += points;
  for (const slam::LineSegment& line : lines) {
    trial.explained += line.points.size();
    trial.rms.push_back(line.rms);
  }
}

void Compare(LogTrial& trial, const Lines& lines, const Lines& next, const slam::Pose2& T_next_this) {
  for (const slam::LineSegment& line : lines) {
    if (line.Length() <= kLong) continue;
    ++trial.lines;
    const MovedLine moved = Moved(line, T_next_this);
    if (!IsInView(moved)) continue;
    ++trial.repeatable;
    const slam::LineSegment* const again = Again(moved, next);
    if (again == nullptr) continue;
    ++trial.repeated;
    trial.angles.push_back(std::abs(slam::WrapAngle(again->angle - moved.angle)));
    trial.offsets.push_back(std::abs(again->Distance(moved.middle)));
  }
}

}  // namespace

std::vector<LogTrial> TryLog(const std::vector<LineDetector>& detectors, const std::filesystem::path& log,
                             int every) {
  std::ifstream in = slam::OpenForReading(log);
  slam::CarmenReader reader(in, log.string());
  std::vector<LogTrial> trials(detectors.size());
  int number = 0;
  for (std::optional<slam::CarmenSweep> sweep = reader.Next(); sweep; ++number) {
    std::optional<slam::CarmenSweep> next = reader.Next();
    if (number % every == 0 && next) {
      const std::vector<Eigen::Vector2d> points = slam::SlicePoints(sweep->scanner, sweep->sweep);
      const std::vector<Eigen::Vector2d> next_points = slam::SlicePoints(next->scanner, next->sweep);
      const slam::Pose2 T_next_this = next->T_odom_laser.Inverse() * sweep->T_odom_laser;
      for (std::size_t d = 0; d < detectors.size(); ++d) {
        const Stopwatch watch;
        const Lines lines = slam::DetectLines(points, detectors[d].options);
        trials[d].seconds.push_back(watch.Seconds());
        Add(trials[d], lines, points.size());
        Compare(trials[d], lines, slam::DetectLines(next_points, detectors[d].options), T_next_this);
      }
    }
    sweep = std::move(next);
  }
  return trials;
}

}  // namespace ariadne::experiments
