#include "slam/io/dxf.h"

#include <algorithm>
#include <map>
#include <string_view>
#include <tuple>

#include "slam/io/chunked_output.h"
#include "slam/io/dxf_colors.h"
#include "slam/io/file.h"
#include "slam/io/writable_drawing.h"

namespace ariadne::slam {
namespace {

// Group codes and flags, by the names of the DXF reference for release 12.
constexpr int kEntity = 0, kText = 1, kName = 2, kLineType = 6, kLayer = 8, kVariable = 9, kX = 10;
constexpr int kColor = 62, kVerticesFollow = 66, kFlags = 70, kComment = 999;
constexpr int kClosed = 1, kPolyline3 = 8, kVertexOfPolyline3 = 32;
constexpr int kMeters = 6;  // of $INSUNITS

/// Colours of vertices repeat: each is looked up in the palette once.
class AciTable {
 public:
  int operator()(const Rgb& color) {
    const auto [place, is_new] = known_.try_emplace(std::tuple(color.r, color.g, color.b), 0);
    if (is_new) place->second = NearestAci(color);
    return place->second;
  }

 private:
  std::map<std::tuple<std::uint8_t, std::uint8_t, std::uint8_t>, int> known_;
};

/// A DXF file is a list of groups: a code on one line, its value on the next.
class DxfOutput {
 public:
  explicit DxfOutput(std::ostream& out) : output_(out) {}

  template <typename T>
  void Group(int code, const T& value) {
    output_.Print("{}\n{}\n", code, value);
  }
  /// The corner-th place of an entity: codes 10, 20, 30 for the first, 11, 21, 31 for the next ...
  void Place(const Eigen::Vector3d& p, int corner = 0) {
    for (int axis = 0; axis < 3; ++axis) output_.Print("{}\n{:.4f}\n", kX + corner + 10 * axis, p[axis]);
  }
  void Begin(std::string_view entity, const DrawingLayer& layer) {
    Group(kEntity, entity);
    Group(kLayer, layer.name);
  }
  void Flush() { output_.Flush(); }

 private:
  ChunkedOutput output_;
};

void BeginSection(DxfOutput& dxf, std::string_view name) {
  dxf.Group(kEntity, "SECTION");
  dxf.Group(kName, name);
}

void BeginTable(DxfOutput& dxf, std::string_view name, std::size_t entries) {
  dxf.Group(kEntity, "TABLE");
  dxf.Group(kName, name);
  dxf.Group(kFlags, entries);
}

void PutHeader(DxfOutput& dxf, const Box3& box) {
  dxf.Group(kComment, "ariadne: metres, z up");
  BeginSection(dxf, "HEADER");
  dxf.Group(kVariable, "$ACADVER");
  dxf.Group(kText, "AC1009");
  dxf.Group(kVariable, "$INSUNITS");
  dxf.Group(kFlags, kMeters);
  dxf.Group(kVariable, "$EXTMIN");
  dxf.Place(box.min());
  dxf.Group(kVariable, "$EXTMAX");
  dxf.Place(box.max());
  dxf.Group(kEntity, "ENDSEC");
}

void PutLineTypes(DxfOutput& dxf) {
  BeginTable(dxf, "LTYPE", 1);
  dxf.Group(kEntity, "LTYPE");
  dxf.Group(kName, "CONTINUOUS");
  dxf.Group(kFlags, 0);
  dxf.Group(3, "Solid line");
  dxf.Group(72, 65);  // alignment, always 'A'
  dxf.Group(73, 0);   // dashes
  dxf.Group(40, "0.0");
  dxf.Group(kEntity, "ENDTAB");
}

void PutLayers(DxfOutput& dxf, const Drawing& drawing, AciTable& aci) {
  BeginTable(dxf, "LAYER", drawing.layers.size());
  for (const DrawingLayer& layer : drawing.layers) {
    dxf.Group(kEntity, "LAYER");
    dxf.Group(kName, layer.name);
    dxf.Group(kFlags, 0);
    dxf.Group(kColor, aci(layer.color));
    dxf.Group(kLineType, "CONTINUOUS");
  }
  dxf.Group(kEntity, "ENDTAB");
}

void PutLine(DxfOutput& dxf, const DrawingLayer& layer, const Polyline3& line) {
  if (line.points.size() == 2) {
    dxf.Begin("LINE", layer);
    dxf.Place(line.points[0]);
    dxf.Place(line.points[1], 1);
    return;
  }
  dxf.Begin("POLYLINE", layer);
  dxf.Group(kVerticesFollow, 1);
  dxf.Place(Eigen::Vector3d::Zero());  // a place that must be there and means nothing
  dxf.Group(kFlags, kPolyline3 | (line.closed ? kClosed : 0));
  for (const Eigen::Vector3d& p : line.points) {
    dxf.Begin("VERTEX", layer);
    dxf.Place(p);
    dxf.Group(kFlags, kVertexOfPolyline3);
  }
  dxf.Begin("SEQEND", layer);
}

Rgb MeanColor(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
  int r = 0, g = 0, b = 0;
  for (const std::uint32_t corner : triangle) {
    r += mesh.colors[corner].r;
    g += mesh.colors[corner].g;
    b += mesh.colors[corner].b;
  }
  const auto third = [](int sum) { return static_cast<std::uint8_t>(sum / 3); };
  return {third(r), third(g), third(b)};
}

void PutTriangles(DxfOutput& dxf, const DrawingLayer& layer, AciTable& aci) {
  const TriangleMesh& mesh = layer.mesh;
  for (const auto& triangle : mesh.triangles) {
    dxf.Begin("3DFACE", layer);
    if (!mesh.colors.empty()) dxf.Group(kColor, aci(MeanColor(mesh, triangle)));
    for (int corner = 0; corner < 4; ++corner) {  // the fourth is the third again
      dxf.Place(mesh.vertices[triangle[static_cast<std::size_t>(std::min(corner, 2))]], corner);
    }
  }
}

void PutLayer(DxfOutput& dxf, const DrawingLayer& layer, AciTable& aci) {
  for (const Eigen::Vector3d& p : layer.points) {
    dxf.Begin("POINT", layer);
    dxf.Place(p);
  }
  for (const Polyline3& line : layer.lines) PutLine(dxf, layer, line);
  PutTriangles(dxf, layer, aci);
}

void PutDrawing(std::ostream& out, const Drawing& drawing) {
  DxfOutput dxf(out);
  AciTable aci;
  PutHeader(dxf, BoxAround(drawing));
  BeginSection(dxf, "TABLES");
  PutLineTypes(dxf);
  PutLayers(dxf, drawing, aci);
  dxf.Group(kEntity, "ENDSEC");
  BeginSection(dxf, "ENTITIES");
  for (const DrawingLayer& layer : drawing.layers) PutLayer(dxf, layer, aci);
  dxf.Group(kEntity, "ENDSEC");
  dxf.Group(kEntity, "EOF");
  dxf.Flush();
}

}  // namespace

void WriteDxf(const std::filesystem::path& path, const Drawing& drawing) {
  CheckWritable(drawing, path);
  WriteFileAtomically(path, [&](std::ostream& out) { PutDrawing(out, drawing); });
}

}  // namespace ariadne::slam
