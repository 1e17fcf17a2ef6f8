#include "slam/io/writable_drawing.h"

#include <algorithm>
#include <set>

#include "slam/base/error.h"
#include "slam/map/layer_names.h"

namespace ariadne::slam {
namespace {

namespace fs = std::filesystem;

constexpr double kFarthest = 1e6;  // beyond, a float holds no decimetres, and something went wrong [m]

/// `what` is "vertex", "point" ...; `where` the layer, or nothing.
void CheckPlaces(const std::vector<Eigen::Vector3d>& places, std::string_view what, std::string_view where,
                 const fs::path& path) {
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Eigen::Vector3d& p = places[i];
    if (p.cwiseAbs().maxCoeff() <= kFarthest && p.allFinite()) continue;
    Fail("{}: cannot be written: {} {}{} is ({}, {}, {}) m; a place must be finite and within 1000 km",
         path.string(), what, i, where, p.x(), p.y(), p.z());
  }
}

void CheckMesh(const TriangleMesh& mesh, std::string_view where, const fs::path& path) {
  CheckPlaces(mesh.vertices, "vertex", where, path);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const std::uint32_t highest = *std::ranges::max_element(mesh.triangles[i]);
    if (highest < mesh.vertices.size()) continue;
    Fail("{}: cannot be written: triangle {}{} names vertex {}, but there are only {}", path.string(), i,
         where, highest, mesh.vertices.size());
  }
  if (!mesh.colors.empty() && mesh.colors.size() != mesh.vertices.size()) {
    Fail("{}: cannot be written: {} colours for {} vertices{}; give one per vertex or none", path.string(),
         mesh.colors.size(), mesh.vertices.size(), where);
  }
}

void CheckLayer(const DrawingLayer& layer, const fs::path& path) {
  if (!IsLayerName(layer.name)) {
    Fail("{}: cannot be written: a layer cannot be named '{}'; use 1 to {} letters, digits, '_' and '-'",
         path.string(), layer.name, kMaxLayerName);
  }
  const std::string where = fmt::format(" of layer '{}'", layer.name);
  CheckPlaces(layer.points, "point", where, path);
  for (const Polyline3& line : layer.lines) {
    if (line.points.size() < 2) {
      Fail("{}: cannot be written: a line{} has fewer than two points", path.string(), where);
    }
    CheckPlaces(line.points, "line point", where, path);
  }
  CheckMesh(layer.mesh, where, path);
}

bool IsEmpty(const DrawingLayer& layer) {
  return layer.points.empty() && layer.lines.empty() && layer.mesh.triangles.empty();
}

std::string InLowerCase(std::string name) {
  for (char& c : name) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return name;
}

}  // namespace

void CheckWritable(const TriangleMesh& mesh, const fs::path& path) {
  if (mesh.triangles.empty()) Fail("{}: cannot be written: the mesh has no triangles", path.string());
  CheckMesh(mesh, "", path);
}

void CheckWritable(const Drawing& drawing, const fs::path& path) {
  if (std::ranges::all_of(drawing.layers, IsEmpty)) {
    Fail("{}: cannot be written: the drawing is empty", path.string());
  }
  std::set<std::string> names;
  for (const DrawingLayer& layer : drawing.layers) {
    CheckLayer(layer, path);
    if (!names.insert(InLowerCase(layer.name)).second) {
      Fail("{}: cannot be written: two layers are named '{}', if case does not count", path.string(),
           layer.name);
    }
  }
}

Box3 BoxAround(const Drawing& drawing) {
  Box3 box;
  for (const DrawingLayer& layer : drawing.layers) {
    box.extend(BoxAround(layer.points));
    for (const Polyline3& line : layer.lines) box.extend(BoxAround(line.points));
    box.extend(BoxAround(layer.mesh.vertices));
  }
  return box;
}

}  // namespace ariadne::slam
