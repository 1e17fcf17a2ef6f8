#include "control/resample_path.h"

#include <cmath>

namespace ariadne::control {
namespace {

/// Intervals that a motion of one arc takes; what rounding makes of standing counts for nothing.
double IntervalsOf(const ApproachSample& from, const ApproachSample& to, const PathSampling& sampling) {
  const double duration = to.time - from.time;
  return duration * (sampling.per_meter * std::abs(from.command.forward) +
                     sampling.per_radian * std::abs(from.command.turning));
}

}  // namespace

std::vector<slam::Pose2> ResamplePath(const std::vector<ApproachSample>& samples,
                                      const PathSampling& sampling) {
  CheckOptions(sampling, "sampling.");
  if (samples.empty()) Fail("a path without a pose cannot be sampled");
  double total = 0.0;
  for (std::size_t k = 1; k < samples.size(); ++k)
    total += IntervalsOf(samples[k - 1], samples[k], sampling);
  const double count = std::ceil(total - 1e-9);
  std::vector<slam::Pose2> poses{samples.front().T_map_robot};
  double passed = 0.0;
  for (std::size_t k = 1; k < samples.size(); ++k) {
    const double intervals = IntervalsOf(samples[k - 1], samples[k], sampling);
    const double duration = samples[k].time - samples[k - 1].time;
    for (;;) {
      const double next = static_cast<double>(poses.size()) * total / count;
      if (intervals == 0.0 || next >= total * (1.0 - 1e-12) || next > passed + intervals) break;
      const double time = duration * (next - passed) / intervals;
      const DriveCommand& command = samples[k - 1].command;
      poses.push_back(samples[k - 1].T_map_robot *
                      slam::Pose2::Exp({command.forward * time, 0.0, command.turning * time}));
    }
    passed += intervals;
  }
  if (count > 0.0) poses.push_back(samples.back().T_map_robot);
  return poses;
}

}  // namespace ariadne::control
