#include "experiments/studies/register_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <optional>

#include "experiments/render/color_map.h"
#include "experiments/render/png_file.h"
#include "experiments/report/map_pictures.h"
#include "slam/io/file.h"
#include "slam/io/g2o.h"
#include "slam/io/ply.h"
#include "slam/io/trajectory.h"
#include "slam/io/uos_pose.h"

namespace ariadne::experiments {
namespace {

constexpr std::size_t kPicturePoints =
    4'000'000;  // of all scans together; pictures do not get better with more

constexpr const char* kRegisterReadme =
    R"(What this run has left (units m, rad, s; x forward, y left, z up)

report.html     all of it at a glance, with the map in 3D, in any browser
config.yaml     all options, with their values; running it again gives the same bytes
manifest.json   what the run was made with: commit, compiler, libraries, SHA-256 of the inputs
progress.json   how far the run has come: running, finished or failed
metrics.json    the results in numbers
scans.csv       a line per scan: its first alignment, and how far it moved from its guess
steps.csv       a line per alignment: which scan, to which others, how it ended, what moved
iterations.csv  a line per iteration of each alignment
covariances.csv a line per alignment: upper triangle of the covariance of T_map_laser in its tangent space,
                (x, y, z, rx, ry, rz) in the frame of the laser
closures.csv    graph, joint: a line per closure of a loop that was tried
passes.csv      graph, joint: a line per optimization of many poses at once
residuals.csv   distances between overlapping scans, before (odometry) and after
trajectory.tum  the pose of the laser at each scan, the number of the scan as its time (evo reads this)
poses.txt       the same as 3x4 matrices after the names of the scans
graph.g2o       graph, joint: the scans as a pose graph with its edges (ariadne optimize reads this)
scans/*.frames  the pose of each scan, before and after, for 3DTK's show (centimetres, left-handed)
map.ply         all points within range, in map coordinates, with scan index and colour per scan
                (CloudCompare, MeshLab)
figures/        the map from above before and after, and at an angle
timing.json     how long it took; the only file that differs from run to run
)";

void WriteTables(const RegisterLog& log, const RunDirectory& run) {
  run.WriteText("README.txt", kRegisterReadme);
  run.WriteCsv("scans.csv", log.scans);
  run.WriteCsv("steps.csv", log.steps);
  run.WriteCsv("iterations.csv", log.iterations);
  run.WriteCsv("covariances.csv", log.covariances);
  if (log.graph.graph.nodes.empty()) return;
  run.WriteCsv("closures.csv", log.closures);
  run.WriteCsv("passes.csv", log.passes);
  slam::WriteFileAtomically(run.File("graph.g2o"),
                            [&](std::ostream& out) { slam::WriteG2o(out, log.graph.graph); });
}

void WritePoses(const ScanSource& source, const RegisterLog& log, const RunDirectory& run) {
  std::vector<slam::StampedPose> trajectory;
  std::vector<slam::NamedPose> poses;
  for (std::size_t i = 0; i < source.size(); ++i) {
    const slam::Pose3& T_map_laser = log.T_map_laser[i];
    trajectory.push_back({static_cast<double>(i), T_map_laser});
    poses.push_back({source.name(i), T_map_laser});
    const std::vector<slam::UosFrame> frames{{source.T_odom_laser(i)}, {T_map_laser}};
    slam::WriteFileAtomically(run.File("scans/" + source.name(i) + ".frames"),
                              [&](std::ostream& out) { slam::WriteUosFrames(out, frames); });
  }
  slam::WriteFileAtomically(run.File("trajectory.tum"),
                            [&](std::ostream& out) { slam::WriteTum(out, trajectory); });
  slam::WriteFileAtomically(run.File("poses.txt"),
                            [&](std::ostream& out) { slam::WritePoseList(out, poses); });
}

/// A cloud with every stride-th point of another.
slam::PointCloud Thinned(const slam::PointCloud& cloud, std::size_t stride) {
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < cloud.size(); i += stride) indices.push_back(i);
  return slam::Selected(cloud, indices);
}

/// Writes the scans into the map as they are read once more, and returns thinned ones for the pictures.
std::vector<slam::PosedCloud> WriteMap(const RegisterOptions& options, const ScanSource& source,
                                       const RegisterLog& log, const RunDirectory& run,
                                       ProgressDisplay& progress) {
  const std::size_t points = std::accumulate(log.points.begin(), log.points.end(), std::size_t{0});
  const std::size_t stride = 1 + points / kPicturePoints;
  std::optional<slam::AtomicFile> file;
  std::optional<slam::PlyWriter> writer;
  if (options.output.map) {
    file.emplace(run.File("map.ply"));
    writer.emplace(file->stream(), slam::PlyEncoding::kBinary,
                   slam::PlyColumns{.reflectance = log.has_reflectance, .colors = true, .scan_index = true},
                   points);
  }
  std::vector<slam::PosedCloud> thinned;
  for (std::size_t i = 0; i < source.size(); ++i) {
    progress.Show(fmt::format("writing the map: {} of {}", i + 1, source.size()));
    const auto [min_range, max_range] = options.mapper.scan;
    const slam::PointCloud cloud_laser =
        slam::WithinRange(source.Read(i).cloud_laser, min_range, max_range);
    const Rgb color = CategoricalColor(i);
    const std::array<slam::PlyWriter::Rgb, 1> ply_color{{{color.r, color.g, color.b}}};
    if (writer) {
      writer->Add(slam::Transformed(log.T_map_laser[i], cloud_laser),
                  {.colors = ply_color, .scan_index = static_cast<std::int32_t>(i)});
    }
    if (options.output.figures)
      thinned.push_back({source.name(i), Thinned(cloud_laser, stride), log.T_map_laser[i]});
  }
  if (writer) {
    writer->Finish();
    file->Commit();
  }
  return thinned;
}

}  // namespace

std::vector<slam::PosedCloud> WriteRegisterOutput(const RegisterOptions& options, const ScanSource& source,
                                                  const RegisterLog& log, const RunDirectory& run,
                                                  ProgressDisplay& progress) {
  WriteTables(log, run);
  WritePoses(source, log, run);
  if (!options.output.map && !options.output.figures) return {};
  std::vector<slam::PosedCloud> after = WriteMap(options, source, log, run, progress);
  if (!options.output.figures) return {};
  std::vector<slam::PosedCloud> before = after;
  for (std::size_t i = 0; i < before.size(); ++i) before[i].T_map_laser = source.T_odom_laser(i);
  WritePng(run.File("figures/top_before.png"), TopPicture(before, after, "Before: first guesses"));
  WritePng(run.File("figures/top_after.png"), TopPicture(after, after, "After registration"));
  WritePng(run.File("figures/oblique.png"), ObliquePicture(after, "After registration"));
  return after;
}

}  // namespace ariadne::experiments
