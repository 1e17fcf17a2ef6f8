#include "slam/io/gltf.h"

#include <cmath>
#include <limits>
#include <string>

#include "slam/base/error.h"
#include "slam/geometry/box3.h"
#include "slam/io/chunked_output.h"
#include "slam/io/file.h"
#include "slam/io/writable.h"
#include "slam/io/writable_drawing.h"

namespace ariadne::slam {
namespace {

// Numbers that glTF 2.0 gives to types and uses.
constexpr std::uint32_t kMagic = 0x46546C67, kVersion = 2;
constexpr std::uint32_t kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;
constexpr std::size_t kFileHead = 12, kChunkHead = 8;
constexpr int kFloat = 5126, kUint16 = 5123, kUint32 = 5125, kVertices = 34962, kIndices = 34963;

/// Where the parts of the binary chunk begin; each begins at a multiple of 4 bytes, as it must. [B]
struct BinaryLayout {
  explicit BinaryLayout(const TriangleMesh& mesh)
      : indices(12 * mesh.vertices.size()),
        colors(indices + 12 * mesh.triangles.size()),
        end(colors + 8 * mesh.colors.size()) {}

  std::size_t indices;
  std::size_t colors;
  std::size_t end;
};

/// sRGB to linear, of 16 bits: 8 would not tell dark colours from each other.
std::uint16_t Linear(std::uint8_t share) {
  const double s = share / 255.0;
  const double linear = s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
  return static_cast<std::uint16_t>(std::lround(65535.0 * linear));
}

std::string FloatList(const Eigen::Vector3d& v) {
  return fmt::format("[{},{},{}]", FloatCoordinate(v.x()), FloatCoordinate(v.y()), FloatCoordinate(v.z()));
}

std::string BufferView(std::size_t begin, std::size_t end, int target) {
  return fmt::format(R"({{"buffer":0,"byteOffset":{},"byteLength":{},"target":{}}})", begin, end - begin,
                     target);
}

std::string BufferViews(const TriangleMesh& mesh, const BinaryLayout& layout) {
  std::string views = fmt::format("{},{}", BufferView(0, layout.indices, kVertices),
                                  BufferView(layout.indices, layout.colors, kIndices));
  if (!mesh.colors.empty()) views += fmt::format(",{}", BufferView(layout.colors, layout.end, kVertices));
  return views;
}

std::string Accessors(const TriangleMesh& mesh) {
  const Box3 box = BoxAround(mesh.vertices);
  std::string accessors =
      fmt::format(R"({{"bufferView":0,"componentType":{},"count":{},"type":"VEC3","min":{},"max":{}}})",
                  kFloat, mesh.vertices.size(), FloatList(box.min()), FloatList(box.max()));
  accessors += fmt::format(R"(,{{"bufferView":1,"componentType":{},"count":{},"type":"SCALAR"}})", kUint32,
                           3 * mesh.triangles.size());
  if (!mesh.colors.empty()) {
    accessors +=
        fmt::format(R"(,{{"bufferView":2,"componentType":{},"normalized":true,"count":{},"type":"VEC4"}})",
                    kUint16, mesh.colors.size());
  }
  return accessors;
}

/// The description of the binary chunk, filled with blanks to a multiple of 4 bytes.
std::string Json(const TriangleMesh& mesh, const BinaryLayout& layout) {
  const double half = std::sqrt(0.5);  // -90 deg about x: z becomes y
  std::string json =
      R"({"asset":{"version":"2.0","generator":"ariadne"},"scene":0,"scenes":[{"nodes":[0]}],)";
  json += fmt::format(R"("nodes":[{{"name":"map","mesh":0,"rotation":[{},0,0,{}]}}],)", -half, half);
  json += R"("materials":[{"doubleSided":true,"pbrMetallicRoughness":{"metallicFactor":0}}],)";
  json += fmt::format(R"("meshes":[{{"primitives":[{{"attributes":{{"POSITION":0{}}},)",
                      mesh.colors.empty() ? "" : R"(,"COLOR_0":2)");
  json += R"("indices":1,"material":0}]}],)";
  json += fmt::format(R"("buffers":[{{"byteLength":{}}}],)", layout.end);
  json +=
      fmt::format(R"("bufferViews":[{}],"accessors":[{}]}})", BufferViews(mesh, layout), Accessors(mesh));
  json.append((4 - json.size() % 4) % 4, ' ');
  return json;
}

void PutBinary(ChunkedOutput& glb, const TriangleMesh& mesh) {
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    for (const double coordinate : vertex) glb.PutBytes(FloatCoordinate(coordinate));
  }
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) glb.PutBytes(corner);
  }
  constexpr auto kOpaque = std::numeric_limits<std::uint16_t>::max();
  for (const Rgb& color : mesh.colors) {
    for (const std::uint16_t share : {Linear(color.r), Linear(color.g), Linear(color.b), kOpaque}) {
      glb.PutBytes(share);
    }
  }
}

/// All lengths stand before the data, in 32 bits.
void PutFile(std::ostream& out, const TriangleMesh& mesh, const std::string& json, std::size_t binary) {
  ChunkedOutput glb(out);
  const auto put = [&](std::size_t number) { glb.PutBytes(static_cast<std::uint32_t>(number)); };
  put(kMagic);
  put(kVersion);
  put(kFileHead + kChunkHead + json.size() + kChunkHead + binary);
  put(json.size());
  put(kJsonChunk);
  glb.Print("{}", json);
  put(binary);
  put(kBinaryChunk);
  PutBinary(glb, mesh);
  glb.Flush();
}

}  // namespace

void WriteGlb(const std::filesystem::path& path, const TriangleMesh& mesh) {
  CheckWritable(mesh, path);
  const BinaryLayout layout(mesh);
  const std::string json = Json(mesh, layout);
  if (layout.end + json.size() > std::numeric_limits<std::uint32_t>::max() - 64) {
    Fail("{}: cannot be written: the mesh takes {} bytes, and glTF has room for 4 GB; write it as ply",
         path.string(), layout.end);
  }
  WriteFileAtomically(path, [&](std::ostream& out) { PutFile(out, mesh, json, layout.end); });
}

}  // namespace ariadne::slam
