#include "slam/io/ply_mesh.h"

#include "slam/io/chunked_output.h"
#include "slam/io/file.h"
#include "slam/io/writable.h"
#include "slam/io/writable_drawing.h"

namespace ariadne::slam {
namespace {

static_assert(sizeof(Rgb) == 3);  // its bytes go to the file as they are

void PutHeader(ChunkedOutput& ply, const TriangleMesh& mesh) {
  ply.Print("ply\nformat binary_little_endian 1.0\n");
  ply.Print("comment ariadne: metres, x forward, y left, z up\n");
  ply.Print("element vertex {}\n", mesh.vertices.size());
  ply.Print("property float x\nproperty float y\nproperty float z\n");
  if (!mesh.colors.empty()) ply.Print("property uchar red\nproperty uchar green\nproperty uchar blue\n");
  ply.Print("element face {}\n", mesh.triangles.size());
  ply.Print("property list uchar int vertex_indices\nend_header\n");
}

void PutMesh(std::ostream& out, const TriangleMesh& mesh) {
  ChunkedOutput ply(out);
  PutHeader(ply, mesh);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    for (const double coordinate : mesh.vertices[i]) ply.PutBytes(FloatCoordinate(coordinate));
    if (!mesh.colors.empty()) ply.PutBytes(mesh.colors[i]);
  }
  for (const auto& triangle : mesh.triangles) {
    ply.PutBytes(std::uint8_t{3});
    for (const std::uint32_t corner : triangle) ply.PutBytes(corner);
  }
  ply.Flush();
}

}  // namespace

void WritePlyMesh(const std::filesystem::path& path, const TriangleMesh& mesh) {
  CheckWritable(mesh, path);
  WriteFileAtomically(path, [&](std::ostream& out) { PutMesh(out, mesh); });
}

}  // namespace ariadne::slam
