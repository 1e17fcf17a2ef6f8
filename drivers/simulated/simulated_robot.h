#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "drivers/differential_frames.h"
#include "drivers/robot.h"
#include "drivers/simulated/ais_scanner.h"
#include "drivers/simulated/safety_scanners.h"
#include "drivers/simulated/simulated_base.h"
#include "slam/base/parallel.h"

namespace ariadne::drivers {

struct SimulatedRobotOptions {
  SimulatedBaseOptions base;
  AisScannerOptions ais;
  SafetyScannerOptions safety;
  DifferentialFrameOptions frames;
  int threads = 1;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("base", self.base, "wheels, encoders and what they carry (Sec. 2.1)");
    visit("ais", self.ais, "the 3D scanner (Sec. 2.2)");
    visit("safety", self.safety, "the 2D scanners at both ends (Sec. 2.1)");
    visit("frames", self.frames, "when a scan is repeated because something moved (Sec. 3.4)");
    visit("threads", self.threads, Unit(""), Range{1, 1024}, "of a scan; the result does not depend on it");
  }
};

/// Ariadne in a world that is known exactly. A mission knows it as a Robot; the truth is for metrics. Time
/// is simulated: it goes on while the robot drives, waits, brakes or takes a 3D scan. The same seed gives
/// the same bytes, whatever the number of threads.
class SimulatedRobot : public Robot {
 public:
  /// Stands at the world's start at time 0. Robots may share a scene.
  SimulatedRobot(std::shared_ptr<const RayScene> scene, const SimulatedRobotOptions& options,
                 std::uint64_t seed);

  double Now() const override { return base_.Now(); }
  slam::Pose3 T_base_laser() const override;

  /// Advances time by the braking and by the duration of the scan, once more for each repetition. A scan
  /// that was repeated max_repeats times is kept as it is. Without safety scanners nothing watches.
  slam::Scan TakeScan() override;

  /// Sweeps are those that have just ended: they were taken on the way to where the robot is now.
  slam::LaserSweep TakeSweep() override;
  std::vector<SafetySweep> TakeSafetySweeps() override;

  /// What the calls above do to the robot and to its time, without their results, most of whose rays need
  /// not be cast: so a simulation is brought to where it was before.
  void SkipScan();
  void SkipSweep() { ++sweeps_; }
  void SkipSafetySweeps() { ++safety_sweeps_; }

  RobotState State() override { return base_.State(); }
  void Drive(const Velocity& velocity) override { base_.Drive(velocity); }
  void WaitUntil(double time) override { base_.WaitUntil(time); }

  const slam::Pose2& T_map_base_true() const { return base_.T_map_base_true(); }
  const std::vector<TruePose>& path_true() const { return base_.path_true(); }
  const std::vector<Collision>& collisions() const { return base_.collisions(); }
  int repeated_scans() const { return repeated_scans_; }

 private:
  using TakeAt = std::function<void(double start, std::uint64_t scan_number)>;

  void ScanUntilNothingMoves(const TakeAt& take);
  std::vector<SafetySweep> SafetySweepsUntil(double end);
  bool SomethingMoved(double start, double end);

  std::shared_ptr<const RayScene> scene_;
  SimulatedRobotOptions options_;
  std::uint64_t seed_;
  Parallel parallel_;
  SimulatedBase base_;
  std::uint64_t scans_ = 0;  // these numbers name the streams of the scanners' noise
  std::uint64_t sweeps_ = 0;
  std::uint64_t safety_sweeps_ = 0;
  int repeated_scans_ = 0;
};

}  // namespace ariadne::drivers
