#include "experiments/studies/feature_trials.h"

#include "drivers/simulated/ais_scanner.h"
#include "drivers/simulated/random_room.h"
#include "slam/base/stopwatch.h"
#include "slam/extract/slice_points.h"

namespace ariadne::experiments {
namespace {

/// A room with a scanner in it.
struct RoomView {
  drivers::RayScene scene;
  slam::Pose3 T_map_base;
};

std::uint64_t SeedOf(int seed, int room) {
  return static_cast<std::uint64_t>(seed) + static_cast<std::uint64_t>(room);
}

RoomView DrawView(std::uint64_t seed, const drivers::AisScannerOptions& scanner) {
  RandomStream stream = NamedStream(seed, "feature_room");
  const drivers::Room room = drivers::DrawRoom(stream);
  const Eigen::Vector3d viewpoint_map = drivers::DrawViewpoint(stream, room);
  const double heading = DrawUniform(stream, -3.0, 3.0);
  slam::Pose3 T_map_base = slam::ToPose3({heading, Eigen::Vector2d::Zero()});
  const slam::Pose3 T_base_laser = drivers::AisMounting(scanner).T_base_laser;
  T_map_base.translation = viewpoint_map - T_map_base * T_base_laser.translation;
  return {drivers::RayScene(drivers::ToWorld(room)), T_map_base};
}

}  // namespace

std::vector<LineDetector> LineDetectors(const slam::LineOptions& options) {
  const auto with = [&](const std::string& name, slam::LineMethod method) {
    LineDetector detector{name, options};
    detector.options.method = method;
    return detector;
  };
  std::vector<LineDetector> detectors{with("length_ratio", slam::LineMethod::kLengthRatio),
                                      with("hough_ordered", slam::LineMethod::kHough),
                                      with("hough_unordered", slam::LineMethod::kHough),
                                      with("split_and_merge", slam::LineMethod::kSplitAndMerge)};
  detectors[1].options.hough.order = slam::PointOrder::kOrdered;
  detectors[2].options.hough.order = slam::PointOrder::kUnordered;
  return detectors;
}

std::vector<LineTrial> TryLines(const std::vector<LineDetector>& detectors, int rooms, int seed,
                                const drivers::AisScannerOptions& scanner, const OnRoom& on_room) {
  std::vector<LineTrial> trials(detectors.size());
  const drivers::SweepMounting mounting = drivers::AisMounting(scanner);
  for (int room = 0; room < rooms; ++room) {
    on_room(room);
    const std::uint64_t room_seed = SeedOf(seed, room);
    const RoomView view = DrawView(room_seed, scanner);
    const drivers::Motion standing = drivers::Standing(view.T_map_base);
    const slam::LaserSweep sweep = drivers::TakeAisSweep(view.scene, standing, 0.0, scanner, room_seed, 0);
    const std::vector<drivers::Ray> beams = drivers::SweepBeams(mounting, standing, 0.0, 0.0, 0.0);
    const std::vector<TrueWall> walls =
        VisibleWalls(view.scene, beams, mounting.scanner, view.T_map_base.rotation);
    const std::vector<Eigen::Vector2d> points = slam::SlicePoints(mounting.scanner, sweep);
    for (std::size_t d = 0; d < detectors.size(); ++d) {
      const Stopwatch watch;
      const std::vector<slam::LineSegment> lines = slam::DetectLines(points, detectors[d].options);
      trials[d].seconds.push_back(watch.Seconds());
      trials[d].score += ScoreLines(lines, walls);
    }
  }
  return trials;
}

std::vector<SurfaceTrial> TrySurfaces(const slam::ExtractSurfacesOptions& options, int rooms, int seed,
                                      const drivers::AisScannerOptions& scanner, const OnRoom& on_room) {
  constexpr auto kMethods = EnumNames<slam::SurfaceMethod>::value.size();
  std::vector<SurfaceTrial> trials(kMethods);
  for (int room = 0; room < rooms; ++room) {
    on_room(room);
    const std::uint64_t room_seed = SeedOf(seed, room);
    const RoomView view = DrawView(room_seed, scanner);
    const std::vector<TruePatch> patches = VisiblePatches(view.scene, view.T_map_base, scanner);
    const slam::PointCloud cloud_laser = slam::ToPointCloud(
        drivers::TakeAisScan(view.scene, view.T_map_base, 0.0, scanner, room_seed, 0, Parallel(1)));
    for (std::size_t m = 0; m < kMethods; ++m) {
      slam::ExtractSurfacesOptions method = options;
      method.method = static_cast<slam::SurfaceMethod>(m);
      const Stopwatch watch;
      const std::vector<slam::PlanarSurface> surfaces = slam::ExtractSurfaces(cloud_laser, method);
      trials[m].seconds.push_back(watch.Seconds());
      trials[m].score += ScoreSurfaces(surfaces, patches, {});
    }
  }
  return trials;
}

}  // namespace ariadne::experiments
