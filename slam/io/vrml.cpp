#include "slam/io/vrml.h"

#include <cmath>
#include <numbers>

#include "slam/geometry/angles.h"
#include "slam/io/chunked_output.h"
#include "slam/io/file.h"
#include "slam/io/writable_drawing.h"

namespace ariadne::slam {
namespace {

constexpr Rgb kMeshColor{200, 200, 200};

void PutColor(ChunkedOutput& vrml, const Rgb& color) {
  vrml.Print("{:.3f} {:.3f} {:.3f}", color.r / 255.0, color.g / 255.0, color.b / 255.0);
}

void PutViewpoint(ChunkedOutput& vrml, std::string_view name, const Box3& box, double from_above) {
  constexpr double kFieldOfView = std::numbers::pi / 4.0;  // VRML's default
  const double radius = std::max(0.5 * box.diagonal().norm(), 0.1);
  const double distance = radius / std::sin(0.5 * kFieldOfView);
  // A viewpoint that is not turned looks along -z, y up: from above. Turned about x, it looks along y.
  const Eigen::Vector3d position =
      box.center() + distance * Eigen::Vector3d(0.0, -std::sin(from_above), std::cos(from_above));
  vrml.Print("Viewpoint {{ description \"{}\" orientation 1 0 0 {:.6f} position {:.4f} {:.4f} {:.4f} }}\n",
             name, from_above, position.x(), position.y(), position.z());
}

void BeginShape(ChunkedOutput& vrml, std::string_view color_field, const Rgb& color,
                std::string_view geometry) {
  vrml.Print("Shape {{ appearance Appearance {{ material Material {{ {} ", color_field);
  PutColor(vrml, color);
  vrml.Print(" }} }} geometry {} {{ ", geometry);
}

void PutCoordinates(ChunkedOutput& vrml, const std::vector<Eigen::Vector3d>& places) {
  for (const Eigen::Vector3d& p : places) vrml.Print("{:.4f} {:.4f} {:.4f}\n", p.x(), p.y(), p.z());
}

void PutPoints(ChunkedOutput& vrml, const DrawingLayer& layer) {
  if (layer.points.empty()) return;
  BeginShape(vrml, "emissiveColor", layer.color, "PointSet");
  vrml.Print("coord Coordinate {{ point [\n");
  PutCoordinates(vrml, layer.points);
  vrml.Print("] }} }} }}\n");
}

void PutLines(ChunkedOutput& vrml, const DrawingLayer& layer) {
  if (layer.lines.empty()) return;
  BeginShape(vrml, "emissiveColor", layer.color, "IndexedLineSet");
  vrml.Print("coord Coordinate {{ point [\n");
  for (const Polyline3& line : layer.lines) PutCoordinates(vrml, line.points);
  vrml.Print("] }} coordIndex [\n");
  std::size_t first = 0;
  for (const Polyline3& line : layer.lines) {
    for (std::size_t i = 0; i < line.points.size(); ++i) vrml.Print("{} ", first + i);
    if (line.closed) vrml.Print("{} ", first);
    vrml.Print("-1\n");
    first += line.points.size();
  }
  vrml.Print("] }} }}\n");
}

void PutMesh(ChunkedOutput& vrml, const TriangleMesh& mesh, const Rgb& color) {
  if (mesh.triangles.empty()) return;
  BeginShape(vrml, "diffuseColor", color, "IndexedFaceSet");
  vrml.Print("solid FALSE coord Coordinate {{ point [\n");  // a surface is seen from either side
  PutCoordinates(vrml, mesh.vertices);
  vrml.Print("] }}\n");
  if (!mesh.colors.empty()) {
    vrml.Print("colorPerVertex TRUE color Color {{ color [\n");
    for (const Rgb& rgb : mesh.colors) {
      PutColor(vrml, rgb);
      vrml.Print("\n");
    }
    vrml.Print("] }}\n");
  }
  vrml.Print("coordIndex [\n");
  for (const auto& [a, b, c] : mesh.triangles) vrml.Print("{} {} {} -1\n", a, b, c);
  vrml.Print("] }} }}\n");
}

/// Everything that a scene has around its groups.
void PutScene(std::ostream& out, const Box3& box, const auto& put_groups) {
  ChunkedOutput vrml(out);
  vrml.Print("#VRML V2.0 utf8\n");
  vrml.Print("WorldInfo {{ title \"ariadne\" info [ \"metres; z is up within the Transform\" ] }}\n");
  vrml.Print("Background {{ skyColor [ 1 1 1 ] }}\n");  // the default is black, as lines often are
  vrml.Print("Transform {{ rotation 1 0 0 {:.9f} children [\n", -0.5 * std::numbers::pi);
  PutViewpoint(vrml, "from the front and above", box, RadFromDeg(60.0));
  PutViewpoint(vrml, "from above", box, 0.0);
  put_groups(vrml);
  vrml.Print("] }}\n");
  vrml.Flush();
}

}  // namespace

void WriteVrml(const std::filesystem::path& path, const Drawing& drawing) {
  CheckWritable(drawing, path);
  WriteFileAtomically(path, [&](std::ostream& out) {
    PutScene(out, BoxAround(drawing), [&](ChunkedOutput& vrml) {
      for (const DrawingLayer& layer : drawing.layers) {
        vrml.Print("DEF layer_{} Group {{ children [\n", layer.name);
        PutPoints(vrml, layer);
        PutLines(vrml, layer);
        PutMesh(vrml, layer.mesh, layer.color);
        vrml.Print("] }}\n");
      }
    });
  });
}

void WriteVrml(const std::filesystem::path& path, const TriangleMesh& mesh) {
  CheckWritable(mesh, path);
  WriteFileAtomically(path, [&](std::ostream& out) {
    PutScene(out, BoxAround(mesh.vertices), [&](ChunkedOutput& vrml) { PutMesh(vrml, mesh, kMeshColor); });
  });
}

}  // namespace ariadne::slam
