#include "experiments/report/viewer_header.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "experiments/render/color_map.h"

namespace ariadne::experiments {
namespace {

using ViewerJson = nlohmann::ordered_json;

/// To a tenth of a millimetre, as short text.
double Short(double value) { return std::round(value * 1e4) / 1e4 + 0.0; }

template <typename Vector>
ViewerJson ToArray(const Vector& p) {
  ViewerJson json = ViewerJson::array();
  for (Eigen::Index i = 0; i < p.size(); ++i) json.push_back(Short(p[i]));
  return json;
}

/// Position, and the directions x (ahead) and z (up) of the laser.
ViewerJson StopsOf(const ViewerScene& scene) {
  std::vector<std::size_t> points(scene.stops.size());
  for (const ViewerPoint& point : scene.points) ++points[point.stop];
  ViewerJson json = ViewerJson::array();
  for (std::size_t i = 0; i < scene.stops.size(); ++i) {
    const ViewerStop& stop = scene.stops[i];
    const Eigen::Matrix3d rotation = stop.T_map_laser.RotationMatrix();
    json.push_back({{"name", stop.name},
                    {"step", stop.step},
                    {"points", points[i]},
                    {"position", ToArray(stop.T_map_laser.translation)},
                    {"ahead", ToArray(rotation.col(0))},
                    {"up", ToArray(rotation.col(2))}});
  }
  return json;
}

ViewerJson BoxesOf(const ViewerScene& scene) {
  ViewerJson json = ViewerJson::array();
  for (const ViewerBox& box : scene.boxes) {
    const Eigen::Vector3d center_map = box.T_map_box * Eigen::Vector3d(box.box.center());
    json.push_back({{"step", box.step},
                    {"center", ToArray(center_map)},
                    {"size", ToArray(Eigen::Vector3d(box.box.sizes()))},
                    {"rotation", ToArray(box.T_map_box.rotation.coeffs())}});  // x, y, z, w
  }
  return json;
}

ViewerJson PathsOf(const std::vector<ViewerPath>& paths) {
  ViewerJson json = ViewerJson::array();
  for (const ViewerPath& path : paths) {
    ViewerJson points = ViewerJson::array();
    for (const Eigen::Vector3d& p : path.points_map) points.push_back(ToArray(p));
    json.push_back({{"step", path.step}, {"points", points}});
  }
  return json;
}

/// Corners as x, y and whether the edge to the next is seen.
ViewerJson RingOf(const planning::LabelledRing& ring) {
  ViewerJson json = ViewerJson::array();
  for (const planning::LabelledCorner& corner : ring)
    json.push_back({Short(corner.p_map.x()), Short(corner.p_map.y()), corner.seen ? 1 : 0});
  return json;
}

ViewerJson PolygonsOf(const ViewerScene& scene) {
  ViewerJson json = ViewerJson::array();
  for (const ViewerPolygon& polygon : scene.polygons) {
    if (polygon.polygon_map.empty()) continue;
    ViewerJson rings = ViewerJson::array({RingOf(polygon.polygon_map.outer)});
    for (const planning::LabelledRing& hole : polygon.polygon_map.holes) rings.push_back(RingOf(hole));
    json.push_back({{"step", polygon.step}, {"z", Short(polygon.z_map)}, {"rings", rings}});
  }
  return json;
}

std::string Hex(Rgb color) { return fmt::format("#{:02x}{:02x}{:02x}", color.r, color.g, color.b); }

ViewerJson ColorsOf() {
  constexpr int kSteps = 8;  // between which the maps are straight
  ViewerJson scans = ViewerJson::array(), heights = ViewerJson::array(), grays = ViewerJson::array();
  for (std::size_t i = 0; i < kCategoricalColors; ++i) scans.push_back(Hex(CategoricalColor(i)));
  for (int i = 0; i <= kSteps; ++i) {
    heights.push_back(Hex(ColorAt(ColorMap::kShore, static_cast<double>(i) / kSteps)));
    grays.push_back(Hex(ColorAt(ColorMap::kGray, static_cast<double>(i) / kSteps)));
  }
  return {{"scan", scans}, {"height", heights}, {"reflectance", grays}};
}

/// "<" would end the script that the JSON stands in, or begin a comment.
std::string WithinHtml(const std::string& json) {
  std::string text;
  for (const char c : json) text += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return text;
}

}  // namespace

std::string HeaderOf(const ViewerScene& scene, const Eigen::AlignedBox3d& box, const ViewerCounts& counts) {
  const bool empty = box.isEmpty();
  const Eigen::Vector3d min = empty ? Eigen::Vector3d::Zero() : Eigen::Vector3d(box.min());
  const Eigen::Vector3d size = empty ? Eigen::Vector3d::Zero() : Eigen::Vector3d(box.sizes());
  ViewerJson json;
  json["box"] = {{"min", {min.x(), min.y(), min.z()}}, {"size", {size.x(), size.y(), size.z()}}};
  json["points"] = {{"count", scene.points.size()},
                    {"of", counts.points},
                    {"spacing", Short(counts.point_spacing)},
                    {"reflectance", scene.has_reflectance}};
  json["mesh"] = {{"vertices", scene.mesh_map.vertices.size()},
                  {"triangles", scene.mesh_map.triangles.size()},
                  {"of", counts.triangles},
                  {"spacing", Short(counts.mesh_spacing)},
                  {"colors", !scene.mesh_map.colors.empty()}};
  json["stops"] = StopsOf(scene);
  json["boxes"] = BoxesOf(scene);
  json["driven"] = PathsOf(scene.driven);
  json["planned"] = PathsOf(scene.planned);
  json["polygons"] = PolygonsOf(scene);
  json["colors"] = ColorsOf();
  // Names may come from files in any encoding; what is not UTF-8 is replaced.
  return WithinHtml(json.dump(-1, ' ', false, ViewerJson::error_handler_t::replace));
}

}  // namespace ariadne::experiments
