#include "experiments/report/viewer_data.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "experiments/render/percentile.h"
#include "experiments/report/viewer_header.h"
#include "experiments/report/viewer_thinning.h"
#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

constexpr double kFarthestPlace = 1e6;  // a coordinate beyond is an error of its maker [m]

template <typename Vector>
void RequirePlace(const Vector& p, const char* what) {
  if (!(p.array().abs() <= kFarthestPlace).all())  // also where it is NaN
    Fail("a 3D view shows what lies within 1000 km, and {} does not", what);
}

void RequirePlaces(const ViewerScene& scene) {
  for (const ViewerPoint& point : scene.points) {
    RequirePlace(point.p_map, "a point");
    if (point.stop >= scene.stops.size())
      Fail("a point of a 3D view belongs to stop {}, but there are {}", point.stop, scene.stops.size());
  }
  for (const ViewerStop& stop : scene.stops) RequirePlace(stop.T_map_laser.translation, "a stop");
  for (const Eigen::Vector3d& p : scene.mesh_map.vertices) RequirePlace(p, "a corner of a mesh");
  for (const ViewerBox& box : scene.boxes) {
    RequirePlace(box.box.min(), "a box");
    RequirePlace(box.box.max(), "a box");
  }
  for (const auto* paths : {&scene.driven, &scene.planned}) {
    for (const ViewerPath& path : *paths) {
      for (const Eigen::Vector3d& p : path.points_map) RequirePlace(p, "a path");
    }
  }
}

/// The stops by their steps, and the points by their stops.
ViewerScene InOrder(ViewerScene scene) {
  std::vector<std::uint32_t> order(scene.stops.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, {}, [&](std::uint32_t i) { return scene.stops[i].step; });
  std::vector<std::uint32_t> place(order.size());
  std::vector<ViewerStop> stops;
  for (const std::uint32_t i : order) {
    place[i] = static_cast<std::uint32_t>(stops.size());
    stops.push_back(scene.stops[i]);
  }
  scene.stops = std::move(stops);
  for (ViewerPoint& point : scene.points) point.stop = place[point.stop];
  std::ranges::stable_sort(scene.points, {}, &ViewerPoint::stop);
  return scene;
}

Eigen::AlignedBox3d BoxOfArrays(const ViewerScene& scene) {
  Eigen::AlignedBox3d box;
  for (const ViewerPoint& point : scene.points) box.extend(point.p_map.cast<double>());
  for (const Eigen::Vector3d& p_map : scene.mesh_map.vertices) box.extend(p_map);
  return box;
}

template <typename Integer>
void AppendLittleEndian(std::string& arrays, Integer value) {
  for (std::size_t byte = 0; byte < sizeof(Integer); ++byte)
    arrays.push_back(static_cast<char>((value >> (8U * byte)) & 0xFFU));
}

void AppendPlace(std::string& arrays, const Eigen::Vector3d& p_map, const Eigen::AlignedBox3d& box) {
  for (int axis = 0; axis < 3; ++axis) {
    const double size = box.sizes()[axis];
    const double share = size > 0.0 ? (p_map[axis] - box.min()[axis]) / size : 0.0;
    AppendLittleEndian(arrays, static_cast<std::uint16_t>(std::lround(share * 65535.0)));
  }
}

/// Reflectance without outliers, as a byte per point.
void AppendReflectance(std::string& arrays, const std::vector<ViewerPoint>& points) {
  std::vector<float> values;
  for (const ViewerPoint& point : points) values.push_back(point.reflectance);
  const float low = Percentile(values, 0.01), high = Percentile(values, 0.99);
  for (const float value : values) {
    const float share = high > low ? std::clamp((value - low) / (high - low), 0.0F, 1.0F) : 0.5F;
    arrays.push_back(static_cast<char>(std::lround(share * 255.0F)));
  }
}

std::string ArraysOf(const ViewerScene& scene, const Eigen::AlignedBox3d& box) {
  std::string arrays;
  for (const std::array<std::uint32_t, 3>& triangle : scene.mesh_map.triangles) {
    for (const std::uint32_t corner : triangle) AppendLittleEndian(arrays, corner);
  }
  for (const ViewerPoint& point : scene.points) AppendPlace(arrays, point.p_map.cast<double>(), box);
  for (const Eigen::Vector3d& p_map : scene.mesh_map.vertices) AppendPlace(arrays, p_map, box);
  if (scene.has_reflectance) AppendReflectance(arrays, scene.points);
  for (const slam::Rgb& color : scene.mesh_map.colors) {
    for (const std::uint8_t channel : {color.r, color.g, color.b}) AppendLittleEndian(arrays, channel);
  }
  return arrays;
}

}  // namespace

ViewerData EncodeScene(const ViewerScene& scene, const ViewerOptions& options) {
  RequirePlaces(scene);
  ViewerCounts counts{scene.points.size(), scene.mesh_map.triangles.size()};
  ViewerScene shown = InOrder(scene);
  ThinnedPoints points = ThinPoints(std::move(shown.points), options.max_points);
  ThinnedMesh mesh = ThinMesh(std::move(shown.mesh_map), options.max_triangles);
  shown.points = std::move(points.points);
  shown.mesh_map = std::move(mesh.mesh_map);
  counts.point_spacing = points.spacing;
  counts.mesh_spacing = mesh.spacing;
  const Eigen::AlignedBox3d box = BoxOfArrays(shown);
  return {HeaderOf(shown, box, counts), ArraysOf(shown, box)};
}

std::string Base64(std::string_view bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < count; ++k)
      group |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[i + k])) << (16U - 8U * k);
    for (std::size_t k = 0; k < 4; ++k)
      text.push_back(k <= count ? kDigits[(group >> (18U - 6U * k)) & 63U] : '=');
  }
  return text;
}

}  // namespace ariadne::experiments
