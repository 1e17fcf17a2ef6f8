#include "experiments/studies/simulate.h"

#include <fmt/format.h>

#include "experiments/metrics/trajectory_error.h"
#include "experiments/run/manifest.h"
#include "experiments/run/run_page.h"
#include "slam/io/cloud_io.h"
#include "slam/io/file.h"
#include "slam/io/trajectory.h"
#include "slam/io/uos_pose.h"

namespace ariadne::experiments {
namespace {

constexpr std::array<const char*, 3> kExtensions{".3d", ".ply", ".pcd"};

void WriteScan(const slam::PosedCloud& scan, ScanFileFormat format, const RunDirectory& run) {
  const std::string stem = "scans/" + scan.name;
  slam::WriteCloud(run.File(stem + kExtensions[static_cast<std::size_t>(format)]), scan.cloud_laser);
  if (format != ScanFileFormat::kUos) return;
  slam::WriteFileAtomically(run.File(stem + ".pose"),
                            [&](std::ostream& out) { slam::WriteUosPose(out, scan.T_map_laser); });
}

void WriteTrajectory(const RunDirectory& run, const std::string& name, const Trajectory& poses) {
  std::vector<slam::StampedPose> stamped;
  for (const slam::Pose3& pose : poses) stamped.push_back({static_cast<double>(stamped.size()), pose});
  slam::WriteFileAtomically(run.File(name), [&](std::ostream& out) { slam::WriteTum(out, stamped); });
}

void WritePoses(const ScanSource& source, const Trajectory& odometry, const RunDirectory& run) {
  std::vector<slam::NamedPose> named;
  for (std::size_t i = 0; i < odometry.size(); ++i) named.push_back({source.name(i), odometry[i]});
  slam::WriteFileAtomically(run.File("scans/poses.txt"),
                            [&](std::ostream& out) { slam::WritePoseList(out, named); });
  WriteTrajectory(run, "odometry.tum", odometry);
}

Json TruthMetrics(const Trajectory& odometry, const Trajectory& truth) {
  const TrajectoryError error = ErrorFromMaster(odometry, truth);
  const PathStatistics path = MeasurePath(truth);
  return {{"path_m", path.length},
          {"turned_rad", path.turned},
          {"odometry_translation_rms_m", error.translation.rms},
          {"odometry_rotation_rms_rad", error.rotation.rms}};
}

}  // namespace

std::string RunSimulate(const SimulateOptions& options, const RunDirectory& run,
                        ProgressDisplay& progress) {
  const ScanSource source(options.input);
  for (const std::string& note : source.notes()) progress.Keep(note);
  WriteManifest(run, source.Files());
  Trajectory odometry, truth;
  std::size_t points = 0;
  for (std::size_t i = 0; i < source.size(); ++i) {
    run.WriteProgress("running", i, source.size());
    progress.Show(fmt::format("{} of {}", i + 1, source.size()));
    const slam::PosedCloud scan = source.Read(i);
    WriteScan(scan, options.format, run);
    points += scan.cloud_laser.size();
    odometry.push_back(scan.T_map_laser);
    if (source.truth(i)) truth.push_back(*source.truth(i));
  }
  WritePoses(source, odometry, run);
  Json metrics{{"scans", source.size()}, {"points", points}};
  if (truth.size() == source.size()) {
    WriteTrajectory(run, "truth.tum", truth);
    WriteTrajectory(run, "scans/truth.tum", truth);
    metrics.update(TruthMetrics(odometry, truth));
  }
  run.WriteJson("metrics.json", metrics);
  FinishRun(run, fmt::format("{} simulated scans", source.size()), source.size());
  return fmt::format("{} scans, {} points; register them: ariadne register {} --out RUN\n", source.size(),
                     points, (run.path() / "scans").string());
}

}  // namespace ariadne::experiments
