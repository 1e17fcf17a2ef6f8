#include "drivers/simulated/ais_scanner.h"

#include <fmt/format.h>

#include "drivers/simulated/range_finder.h"

namespace ariadne::drivers {
namespace {

constexpr std::size_t kSlicesPerChunk = 8;
constexpr std::string_view kDevice = "ais";

int TurnsPerSlice(SlicePoints points) {
  return points == SlicePoints::k181 ? 1 : points == SlicePoints::k361 ? 2 : 4;
}

}  // namespace

SweepMounting AisMounting(const AisScannerOptions& options) {
  const int turns = TurnsPerSlice(options.points);
  SweepMounting mounting;
  mounting.T_base_laser.translation = {options.mount_x, options.mount_y, options.mount_z};
  mounting.scanner = HalfCircle(turns);
  mounting.beams = HalfCircleBeams(turns);
  mounting.mirror_forward = options.mirror_forward;
  mounting.mirror_up = options.mirror_up;
  return mounting;
}

double AisSliceDuration(const AisScannerOptions& options) {
  const slam::ScannerModel scanner = AisMounting(options).scanner;
  return scanner.turn_period * scanner.turns_per_sweep;
}

double AisScanDuration(const AisScannerOptions& options) {
  return AisSliceDuration(options) * options.slices;
}

slam::Scan TakeAisScan(const RayScene& scene, const slam::Pose3& T_map_base, double start_time,
                       const AisScannerOptions& options, std::uint64_t seed, std::uint64_t scan_number,
                       const Parallel& parallel) {
  CheckOptions(options, "ais.");
  const RangeFinder device(std::string(kDevice), options.range_finder, seed);
  const SweepMounting mounting = AisMounting(options);
  const Motion standing = Standing(T_map_base);
  const double duration = AisSliceDuration(options);
  const double pitch_step = (options.highest_pitch - options.lowest_pitch) / options.slices;
  slam::Scan scan;
  scan.scanner = mounting.scanner;
  scan.sweeps.resize(static_cast<std::size_t>(options.slices));
  parallel.For(scan.sweeps.size(), kSlicesPerChunk, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t s = begin; s < end; ++s) {
      const double stamp = start_time + static_cast<double>(s) * duration;
      const double pitch = options.lowest_pitch + static_cast<double>(s) * pitch_step;
      const auto beams = SweepBeams(mounting, standing, stamp, pitch, pitch_step / duration);
      slam::LaserSweep& slice = scan.sweeps[s];
      slice = device.Measure(scene, beams, fmt::format("scan/{}/{}", scan_number, s));
      slice.stamp = stamp;
      slice.pitch = pitch;
      slice.pitch_rate = pitch_step / duration;
    }
  });
  return scan;
}

slam::LaserSweep TakeAisSweep(const RayScene& scene, const Motion& T_map_base, double start_time,
                              const AisScannerOptions& options, std::uint64_t seed,
                              std::uint64_t sweep_number) {
  CheckOptions(options, "ais.");
  const RangeFinder device(std::string(kDevice), options.range_finder, seed);
  const auto beams = SweepBeams(AisMounting(options), T_map_base, start_time, 0.0, 0.0);
  slam::LaserSweep sweep = device.Measure(scene, beams, fmt::format("sweep/{}", sweep_number));
  sweep.stamp = start_time;
  return sweep;
}

}  // namespace ariadne::drivers
