#include "experiments/studies/view.h"

#include <optional>

#include "drivers/simulated/ray_scene.h"
#include "experiments/config/options_io.h"
#include "experiments/metrics/map_error.h"
#include "experiments/render/density_view.h"
#include "experiments/render/fit_camera.h"
#include "experiments/render/overlay.h"
#include "experiments/render/point_view.h"
#include "experiments/render/scales.h"
#include "experiments/render/world_view.h"
#include "experiments/report/map_cameras.h"
#include "experiments/run/data_path.h"
#include "experiments/studies/run_scans.h"
#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

constexpr double kScannerView = 1.75;  // field of view of from=scanner, 100 deg [rad]
constexpr double kLargestError = 0.1;  // that colours tell apart [m]

/// The points in their colours, with what the colours mean.
struct Coloring {
  ColoredPoints points;
  ColorMap map = ColorMap::kShore;
  ValueRange range;
  std::string quantity;  // empty: no scale
};

Coloring ColorByError(const RegisteredMap& map, const HeightBand& heights) {
  if (map.input.folder != "builtin:tour" || !map.T_world_master) {
    Fail("color=error needs a world that is known: a run with input.folder=builtin:tour");
  }
  const TourOptions& tour = map.input.tour;
  const drivers::World world = drivers::LoadWorld(ExpandDataPath(tour.world).string(), tour.geometry);
  const std::vector<Eigen::Vector3d> positions = PositionsInMap(map.scans, heights);
  const std::vector<double> distances =
      SurfaceDistances(positions, PlaceByMaster(map.scans[0].T_map_laser, *map.T_world_master),
                       drivers::SurfaceDistance(world), Parallel(1));
  const ValueRange range{0.0, kLargestError};
  return {ColoredByValue(positions, distances, ColorMap::kHeat, range), ColorMap::kHeat, range,
          "distance from the true surface [m]"};
}

Coloring Color(const RegisteredMap& map, const ViewOptions& options) {
  const HeightBand heights = options.from == ViewFrom::kScanner ? HeightBand{} : WithoutCeiling(map.scans);
  switch (options.color) {
    case ViewColor::kScan:
      return {Lightened(ColoredByScan(map.scans, heights)), {}, {}, ""};
    case ViewColor::kReflectance:
      return {ColoredByReflectance(map.scans, heights), {}, {}, ""};
    case ViewColor::kError:
      return ColorByError(map, heights);
    case ViewColor::kHeight:
      break;
  }
  const std::vector<Eigen::Vector3d> positions = PositionsInMap(map.scans, heights);
  const ValueRange range = HeightRange(positions);
  return {ColoredByHeight(positions, range), ColorMap::kShore, range, "height [m]"};
}

/// The camera at its usual size, made as wide as is asked for.
Camera Resized(Camera camera, int width) {
  const double factor = static_cast<double>(width) / camera.width;
  camera.height = std::max(1, static_cast<int>(camera.height * factor));
  camera.width = width;
  camera.scale *= factor;
  camera.center *= factor;
  return camera;
}

Camera CameraOf(const RegisteredMap& map, const ViewOptions& options) {
  if (options.from == ViewFrom::kTop) return Resized(TopCamera(map.scans), options.width);
  if (options.from == ViewFrom::kOblique) return Resized(ObliqueCamera(map.scans), options.width);
  if (static_cast<std::size_t>(options.scan) >= map.scans.size()) {
    Fail("there is no scan {}: the run has 0 to {}", options.scan, map.scans.size() - 1);
  }
  const slam::Pose3& T_map_laser = map.scans[static_cast<std::size_t>(options.scan)].T_map_laser;
  return LookAt(T_map_laser.translation, T_map_laser * Eigen::Vector3d::UnitX(),
                T_map_laser.rotation * Eigen::Vector3d::UnitZ(), kScannerView,
                {options.width, options.width * 5 / 8});
}

void DrawRobotPath(Image& picture, const Camera& camera, const std::vector<slam::PosedCloud>& scans) {
  std::vector<slam::Pose3> poses;
  std::vector<Eigen::Vector3d> path;
  for (const slam::PosedCloud& scan : scans) {
    poses.push_back(scan.T_map_laser);
    path.push_back(scan.T_map_laser.translation);
  }
  DrawPath(picture, camera, path);
  DrawPoses(picture, camera, poses);
}

/// The corners of everything below the cut.
std::vector<Eigen::Vector3d> CornersBelow(const drivers::World& world, double height) {
  std::vector<Eigen::Vector3d> corners;
  for (const drivers::Body& body : world.bodies) {
    const slam::Pose3 T_map_body = drivers::PoseAt(body.motion, 0.0);
    for (const Eigen::Vector3d& p : body.mesh_body.vertices) {
      const Eigen::Vector3d p_map = T_map_body * p;
      corners.push_back({p_map.x(), p_map.y(), std::min(p_map.z(), height)});
    }
  }
  return corners;
}

}  // namespace

Image ViewRun(const std::filesystem::path& run, const ViewOptions& options) {
  const RegisteredMap map = ReadRegisteredMap(run);
  const Coloring coloring = Color(map, options);
  const Camera camera = CameraOf(map, options);
  Image picture = RenderPoints(coloring.points, camera);
  if (options.from != ViewFrom::kScanner) DrawRobotPath(picture, camera, map.scans);
  if (options.from == ViewFrom::kTop) picture = WithScaleBar(picture, camera);
  if (coloring.quantity.empty()) return picture;
  return WithColorBar(picture, coloring.map, coloring.range, coloring.quantity);
}

Image ViewWorld(const std::string& source, const ViewOptions& options) {
  if (options.from == ViewFrom::kScanner)
    Fail("from=scanner needs a run; a world is seen from top or oblique");
  const drivers::RayScene scene(drivers::LoadWorld(ExpandDataPath(source).string(), options.geometry));
  const std::vector<Eigen::Vector3d> corners = CornersBelow(scene.world(), options.cut_height);
  const bool top = options.from == ViewFrom::kTop;
  const PictureSize size{options.width, options.width * 3 / 4};
  const Camera unfitted =
      top ? TopView(size) : ObliqueView(Eigen::Vector3d::Zero(), {.elevation = 0.75, .size = size});
  const Camera camera = Fitted(unfitted, corners, {.outlier_share = 0.0, .adjust_height = true});
  const WorldViewOptions view{.cut_height = options.cut_height,
                              .color_by_height = options.color == ViewColor::kHeight,
                              .heights = {0.0, options.cut_height}};
  const Image picture = RenderWorld(scene, camera, view, Parallel(2));
  return top ? WithScaleBar(picture, camera) : picture;
}

}  // namespace ariadne::experiments
