#include "slam/geometry/triangulate.h"
#include "slam/map/surface_model.h"

namespace ariadne::slam {
namespace {

/// The twelve edges of a box: two rings and four uprights.
std::vector<Polyline3> EdgesOf(const Box3& box) {
  const auto corner = [&](bool x, bool y, bool z) {
    const Eigen::Vector3d &low = box.min(), &high = box.max();
    return Eigen::Vector3d(x ? high.x() : low.x(), y ? high.y() : low.y(), z ? high.z() : low.z());
  };
  std::vector<Polyline3> edges;
  for (const bool z : {false, true}) {
    edges.push_back(
        {{corner(false, false, z), corner(true, false, z), corner(true, true, z), corner(false, true, z)},
         true});
  }
  for (const bool x : {false, true}) {
    for (const bool y : {false, true}) edges.push_back({{corner(x, y, false), corner(x, y, true)}, false});
  }
  return edges;
}

DrawingLayer LayerOf(const SurfaceModel& model, SurfaceClass surface_class) {
  DrawingLayer layer{std::string(NameOf(surface_class)), ColorOf(surface_class), {}, {}, {}};
  for (std::size_t i = 0; i < model.surfaces_map.size(); ++i) {
    if (model.classes[i] != surface_class) continue;
    Append(layer.mesh, MeshOf(model.surfaces_map[i], layer.color));
    for (std::vector<Eigen::Vector3d>& ring : OutlinePoints(model.surfaces_map[i]))
      layer.lines.push_back({std::move(ring), true});
  }
  return layer;
}

}  // namespace

Rgb ColorOf(SurfaceClass surface_class) {
  switch (surface_class) {
    case SurfaceClass::kFloor:
      return {222, 205, 170};
    case SurfaceClass::kCeiling:
      return {190, 210, 225};
    case SurfaceClass::kWall:
      return {150, 165, 175};
    case SurfaceClass::kObject:
      break;
  }
  return {225, 125, 50};
}

TriangleMesh MeshOf(const PlanarSurface& surface, Rgb color) {
  TriangleMesh mesh;
  Triangles2 flat = Triangulated(surface.outlines);
  for (const Eigen::Vector2d& p : flat.vertices)
    mesh.vertices.push_back(surface.T_frame_plane * Eigen::Vector3d(p.x(), p.y(), 0.0));
  mesh.triangles = std::move(flat.triangles);
  mesh.colors.assign(mesh.vertices.size(), color);
  return mesh;
}

TriangleMesh MeshOf(const SurfaceModel& model) {
  TriangleMesh mesh;
  for (std::size_t i = 0; i < model.surfaces_map.size(); ++i)
    Append(mesh, MeshOf(model.surfaces_map[i], ColorOf(model.classes[i])));
  return mesh;
}

Drawing DrawingOf(const SurfaceModel& model) {
  Drawing drawing;
  for (std::size_t i = 0; i < EnumNames<SurfaceClass>::value.size(); ++i)
    drawing.layers.push_back(LayerOf(model, static_cast<SurfaceClass>(i)));
  DrawingLayer boxes{"boxes", {200, 30, 30}, {}, {}, {}};
  for (const ObjectBox& object : model.objects) {
    for (Polyline3& edge : EdgesOf(object.box)) boxes.lines.push_back(std::move(edge));
  }
  drawing.layers.push_back(std::move(boxes));
  return drawing;
}

}  // namespace ariadne::slam
