#include "drivers/simulated/simulated_robot.h"

#include <algorithm>

namespace ariadne::drivers {
namespace {

const SimulatedRobotOptions& Checked(const SimulatedRobotOptions& options) {
  CheckOptions(options, "robot.");
  return options;
}

double SafetySweepDuration(const SafetyScannerOptions& options) {
  const slam::ScannerModel scanner = HalfCircle(options.half_degree ? 2 : 1);
  return scanner.turn_period * scanner.turns_per_sweep;
}

}  // namespace

SimulatedRobot::SimulatedRobot(std::shared_ptr<const RayScene> scene, const SimulatedRobotOptions& options,
                               std::uint64_t seed)
    : scene_(std::move(scene)),
      options_(Checked(options)),
      seed_(seed),
      parallel_(options.threads),
      base_(scene_->world(), options.base, seed) {}

slam::Pose3 SimulatedRobot::T_base_laser() const { return AisMounting(options_.ais).T_base_laser; }

slam::Scan SimulatedRobot::TakeScan() {
  slam::Scan scan;
  ScanUntilNothingMoves([&](double start, std::uint64_t scan_number) {
    scan = TakeAisScan(*scene_, slam::ToPose3(T_map_base_true()), start, options_.ais, seed_, scan_number,
                       parallel_);
  });
  scan.odometry = State().odometry;  // of the whole scan: the robot stands
  return scan;
}

void SimulatedRobot::SkipScan() {
  ScanUntilNothingMoves([](double, std::uint64_t) {});
}

void SimulatedRobot::ScanUntilNothingMoves(const TakeAt& take) {
  base_.Halt();
  for (int repeats = 0;; ++repeats) {
    const double start = Now();
    take(start, scans_++);
    WaitUntil(start + AisScanDuration(options_.ais));
    if (!SomethingMoved(start, Now()) || repeats == options_.frames.max_repeats) return;
    ++repeated_scans_;
  }
}

/// Differential frames of the time of a scan (Sec. 3.4), the last of them at its end.
bool SimulatedRobot::SomethingMoved(double start, double end) {
  std::vector<std::vector<SafetySweep>> frames;
  double frame_end = start + SafetySweepDuration(options_.safety);
  for (; frame_end < end; frame_end += options_.frames.period) {
    frames.push_back(SafetySweepsUntil(frame_end));
  }
  frames.push_back(SafetySweepsUntil(end));
  return !DetectMotion(frames, options_.frames).empty();
}

slam::LaserSweep SimulatedRobot::TakeSweep() {
  const double start = std::max(0.0, Now() - AisSliceDuration(options_.ais));
  return TakeAisSweep(*scene_, base_.WayBetween(start, Now()), start, options_.ais, seed_, sweeps_++);
}

std::vector<SafetySweep> SimulatedRobot::TakeSafetySweeps() { return SafetySweepsUntil(Now()); }

std::vector<SafetySweep> SimulatedRobot::SafetySweepsUntil(double end) {
  const double start = std::max(0.0, end - SafetySweepDuration(options_.safety));
  return drivers::TakeSafetySweeps(*scene_, base_.WayBetween(start, end), start, options_.safety, seed_,
                                   safety_sweeps_++);
}

}  // namespace ariadne::drivers
