#include "experiments/studies/control_trials.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "control/differential_drive.h"
#include "experiments/metrics/statistics.h"
#include "slam/base/random.h"
#include "slam/geometry/angles.h"

namespace ariadne::experiments {
namespace {

using control::ApproachSample;
using control::DriveCommand;

constexpr double kRounding = 1e-9;

/// Whether the motors could not do it, after what they did before.
bool IsBeyond(const DriveCommand& command, const DriveCommand& before, const control::DriveLimits& limits,
              double period) {
  const control::WheelPair wheels = control::WheelsOf(command.forward, command.turning, limits.track);
  const double fastest_wheel = std::max(std::abs(wheels.left), std::abs(wheels.right));
  const double change = std::abs(command.forward - before.forward) / period;
  const double turning_change = std::abs(command.turning - before.turning) / period;
  return std::abs(command.forward) > limits.max_speed + kRounding ||
         std::abs(command.turning) > limits.max_turning + kRounding ||
         fastest_wheel > limits.max_wheel_speed + kRounding ||
         change > limits.acceleration + kRounding / period ||
         turning_change > limits.turning_acceleration + kRounding / period;
}

double LargestCurvatureBetween(const std::vector<ApproachSample>& samples, double near, double far) {
  double largest = 0.0;
  for (const ApproachSample& sample : samples) {
    const double distance = sample.T_map_robot.translation.norm();
    if (distance < near || distance > far || sample.command.forward == 0.0) continue;
    largest = std::max(largest, std::abs(sample.command.turning / sample.command.forward));
  }
  return largest;
}

bool IsAtGoal(const ControlTrial& trial) {
  return trial.reached && trial.distance <= 0.01 && trial.angle <= slam::RadFromDeg(0.5);
}

std::vector<std::string> RowOfController(const std::string& name, const std::vector<ControlTrial>& trials) {
  std::vector<ControlTrial> own;
  for (const ControlTrial& trial : trials) {
    if (trial.controller == name) own.push_back(trial);
  }
  const auto count = static_cast<double>(own.size());
  const auto quantile = [&own](double p, const std::function<double(const ControlTrial&)>& value) {
    std::vector<double> values;
    for (const ControlTrial& trial : own) values.push_back(value(trial));
    return fmt::format("{:.3f}", Quantile(std::move(values), p));
  };
  const auto detour = [](const ControlTrial& t) { return t.length / t.straight; };
  const auto distance = [](const ControlTrial& t) { return 1e3 * t.distance; };
  const auto angle = [](const ControlTrial& t) { return slam::DegFromRad(t.angle); };
  const auto duration = [](const ControlTrial& t) { return t.duration; };
  const auto far = [](const ControlTrial& t) { return t.curvature_far; };
  const auto near = [](const ControlTrial& t) { return t.curvature_near; };
  const auto changes = [](const ControlTrial& t) { return t.turning_changes; };
  int violations = 0;
  for (const ControlTrial& trial : own) violations += trial.violations;
  const auto at_goal = static_cast<double>(std::ranges::count_if(own, IsAtGoal));
  return {name,
          fmt::format("{}", own.size()),
          fmt::format("{:.4f}", 100.0 * at_goal / count),
          quantile(0.5, detour),
          quantile(0.95, detour),
          quantile(0.5, duration),
          quantile(0.95, duration),
          quantile(1.0, distance),
          quantile(1.0, angle),
          quantile(0.5, far),
          quantile(0.5, near),
          quantile(0.5, changes),
          fmt::format("{}", violations)};
}

}  // namespace

slam::Pose2 DrawStart(std::uint64_t seed, double distance) {
  RandomStream stream = NamedStream(seed, "control/start");
  const double radius = distance * std::sqrt(DrawUniform(stream, 0.0, 1.0));
  const double direction = DrawUniform(stream, -std::numbers::pi, std::numbers::pi);
  return {DrawUniform(stream, -std::numbers::pi, std::numbers::pi),
          {radius * std::cos(direction), radius * std::sin(direction)}};
}

ControlTrial JudgeTrial(const std::string& controller, const control::ApproachResult& result,
                        const control::DriveLimits& limits, double period) {
  const slam::Pose2& end = result.samples.back().T_map_robot;
  ControlTrial trial;
  trial.controller = controller;
  trial.reached = result.status == control::ApproachStatus::kReached;
  trial.distance = end.translation.norm();
  trial.angle = std::abs(end.angle);
  trial.length = result.length;
  trial.straight = result.samples.front().T_map_robot.translation.norm();
  trial.duration = result.duration;
  trial.curvature_far = LargestCurvatureBetween(result.samples, 0.25, 0.5);
  trial.curvature_near = LargestCurvatureBetween(result.samples, 0.02, 0.05);
  DriveCommand before;
  for (const ApproachSample& sample : result.samples) {
    trial.violations += IsBeyond(sample.command, before, limits, period) ? 1 : 0;
    trial.turning_changes += std::abs(sample.command.turning - before.turning);
    before = sample.command;
  }
  return trial;
}

Table ControlTable(const std::vector<ControlTrial>& trials) {
  Table table{{"controller", "starts", "at goal %", "way / line", "95 %", "time s", "95 % s", "worst mm",
               "worst deg", "1/m at 0.5 m", "1/m at 5 cm", "turning", "violations"},
              {}};
  std::vector<std::string> names;
  for (const ControlTrial& trial : trials) {
    if (std::ranges::find(names, trial.controller) == names.end()) names.push_back(trial.controller);
  }
  for (const std::string& name : names) table.rows.push_back(RowOfController(name, trials));
  return table;
}

Table ControlTrialTable(const std::vector<ControlTrial>& trials) {
  Table table{{"controller", "reached", "distance_m", "angle_deg", "length_m", "straight_m", "duration_s",
               "curvature_far_per_m", "curvature_near_per_m", "turning_changes", "violations"},
              {}};
  for (const ControlTrial& t : trials) {
    table.rows.push_back({t.controller, t.reached ? "1" : "0", Exact(t.distance),
                          Exact(slam::DegFromRad(t.angle)), Exact(t.length), Exact(t.straight),
                          Exact(t.duration), Exact(t.curvature_far), Exact(t.curvature_near),
                          Exact(t.turning_changes), fmt::format("{}", t.violations)});
  }
  return table;
}

}  // namespace ariadne::experiments
