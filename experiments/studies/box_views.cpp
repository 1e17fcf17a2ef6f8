#include "experiments/studies/box_views.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "drivers/simulated/ray_scene.h"
#include "drivers/simulated/solids.h"
#include "experiments/render/color_map.h"
#include "experiments/studies/tube_mesh.h"

namespace ariadne::experiments {
namespace {

using Eigen::Vector3d;

constexpr double kFieldOfView = 1.4;               // 80 deg [rad]
constexpr double kNearest = 1.0, kFarthest = 8.0;  // of boxes that count [m]
constexpr double kApart = 3.0;                     // of views [m]
constexpr Rgb kEdgeInk{206, 38, 30};
constexpr Rgb kSurface{196, 200, 206};

drivers::RayScene SceneOfMesh(const slam::TriangleMesh& mesh) {
  drivers::World world;
  if (!mesh.triangles.empty()) world.bodies.push_back({"mesh", mesh, {}, {}});
  return drivers::RayScene(std::move(world));
}

bool ShowsCorner(const Vector3d& corner, const Camera& camera, const drivers::RayScene& scene) {
  const ImagePoint at = Projector(camera)(corner);
  if (at.depth < kNearest || at.u < 0.0 || at.v < 0.0 || at.u > camera.width || at.v > camera.height)
    return false;
  const Vector3d eye = camera.T_camera_map.Inverse().translation;
  const double distance = (corner - eye).norm();
  if (distance > kFarthest) return false;
  constexpr double kSurfaceNear = 0.15;  // corners lie on what they are the corners of, or before it [m]
  return scene.Cast({eye, (corner - eye) / distance}).distance > distance - kSurfaceNear;
}

/// Boxes that show most of the corners that can be seen at once.
int BoxesInView(const slam::SurfaceModel& surfaces, const Camera& camera, const drivers::RayScene& scene) {
  constexpr int kEnough = 4;  // of seven
  int count = 0;
  for (const slam::ObjectBox& object : surfaces.objects) {
    int corners = 0;
    for (int i = 0; i < 8; ++i) {
      const auto corner = static_cast<slam::Box3::CornerType>(i);
      corners += ShowsCorner(object.box.corner(corner), camera, scene) ? 1 : 0;
    }
    count += corners >= kEnough ? 1 : 0;
  }
  return count;
}

/// Over a scanner, as wide as a wide-angle lens, turned from where that looks by an angle [rad].
Camera ViewFrom(const slam::Pose3& T_map_laser, double turn, const PictureSize& size) {
  constexpr double kAbove = 0.5, kDown = 0.25;  // [m], per metre ahead
  const Vector3d eye = T_map_laser.translation + Vector3d(0.0, 0.0, kAbove);
  Vector3d ahead = Eigen::AngleAxisd(turn, Vector3d::UnitZ()) * T_map_laser.RotationMatrix().col(0);
  ahead.z() = 0.0;
  return LookAt(eye, eye + ahead.normalized() - Vector3d(0.0, 0.0, kDown), Vector3d::UnitZ(), kFieldOfView,
                size);
}

/// Whether nothing fills half of the picture from right before the camera.
bool IsOpen(const Camera& camera, const drivers::RayScene& scene) {
  constexpr int kColumns = 9;
  constexpr double kNear = 2.0;  // [m]
  const slam::Pose3 T_map_camera = camera.T_camera_map.Inverse();
  int near = 0;
  for (int i = 0; i < kColumns; ++i) {
    const double u = camera.width * (i + 0.5) / kColumns;
    const Vector3d direction((u - camera.center.x()) / camera.scale, 0.0, 1.0);
    const Vector3d direction_map = T_map_camera.rotation * direction.normalized();
    near += scene.Cast({T_map_camera.translation, direction_map}).distance < kNear ? 1 : 0;
  }
  return 2 * near < kColumns;
}

slam::TriangleMesh Colored(slam::TriangleMesh mesh) {
  if (mesh.colors.empty()) mesh.colors.assign(mesh.vertices.size(), kSurface);
  return mesh;
}

}  // namespace

slam::TriangleMesh Lightened(slam::TriangleMesh mesh) {
  constexpr double kDarkest = 96.0, kLightest = 246.0;
  const auto lifted = [](std::uint8_t value) {
    return ToChannel(kDarkest + (kLightest - kDarkest) * std::sqrt(value / 255.0));
  };
  for (Rgb& color : mesh.colors) color = {lifted(color.r), lifted(color.g), lifted(color.b)};
  return mesh;
}

std::vector<BoxView> BestViews(const BuildingModel& model, const std::vector<slam::Pose3>& T_map_laser,
                               std::size_t count, const PictureSize& size) {
  constexpr int kDirections = 8;
  const drivers::RayScene scene = SceneOfMesh(model.mesh);
  std::vector<BoxView> views;
  for (std::size_t i = 0; i < T_map_laser.size(); ++i) {
    for (int k = 0; k < kDirections; ++k) {
      const Camera camera = ViewFrom(T_map_laser[i], 2.0 * std::numbers::pi * k / kDirections, size);
      if (IsOpen(camera, scene)) views.push_back({i, camera, BoxesInView(model.surfaces, camera, scene)});
    }
  }
  std::ranges::stable_sort(views, [](const BoxView& a, const BoxView& b) { return a.boxes > b.boxes; });
  std::vector<BoxView> best;
  for (const BoxView& view : views) {
    const bool apart = std::ranges::all_of(best, [&](const BoxView& other) {
      return (T_map_laser[other.pose].translation - T_map_laser[view.pose].translation).norm() > kApart;
    });
    if (apart && best.size() < count) best.push_back(view);
  }
  return best;
}

slam::TriangleMesh WithBoxEdges(const slam::TriangleMesh& mesh, const slam::SurfaceModel& surfaces,
                                double radius) {
  slam::TriangleMesh with_boxes = Colored(Lightened(mesh));
  for (const slam::ObjectBox& object : surfaces.objects)
    AppendBoxEdges(with_boxes, object.box, radius, kEdgeInk);
  return with_boxes;
}

slam::TriangleMesh WithSolidBoxes(const slam::TriangleMesh& mesh, const slam::SurfaceModel& surfaces) {
  constexpr double kPale = 0.3;
  slam::TriangleMesh with_boxes = Colored(Lightened(mesh));
  for (Rgb& color : with_boxes.colors) color = Mix(color, kWhite, kPale);
  for (std::size_t i = 0; i < surfaces.objects.size(); ++i)
    AppendPainted(with_boxes, drivers::MakeBox(surfaces.objects[i].box), CategoricalColor(i));
  return with_boxes;
}

}  // namespace ariadne::experiments
