#include "drivers/simulated/mesh_world.h"

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <filesystem>

#include "drivers/simulated/solids.h"
#include "slam/base/error.h"

namespace ariadne::drivers {
namespace {

using Transform = Eigen::Affine3d;

Transform ToEigen(const aiMatrix4x4& m) {
  Eigen::Matrix4d matrix;
  matrix << m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, m.d1, m.d2, m.d3, m.d4;
  return Transform(matrix);
}

/// Turns the axis that points up to z; the others follow in their order.
Eigen::Matrix3d UpToZ(UpAxis up) {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  if (up == UpAxis::kY) R << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  if (up == UpAxis::kX) R << 0, 1, 0, 0, 0, 1, 1, 0, 0;
  return R;
}

/// Formats whose scenes assimp turns to y up, in metres: it reads the axis in COLLADA, glTF fixes it.
bool IsTurnedByAssimp(const std::string& path, const MeshOptions& options) {
  const std::string extension = std::filesystem::path(path).extension().string();
  const bool gltf = extension == ".gltf" || extension == ".glb";
  return gltf || (options.up == UpAxis::kFile && (extension == ".dae" || extension == ".DAE"));
}

Transform FileToMap(const std::string& path, const MeshOptions& options) {
  UpAxis up = options.up;
  if (up == UpAxis::kFile) up = IsTurnedByAssimp(path, options) ? UpAxis::kY : UpAxis::kZ;
  Transform T = Transform::Identity();
  T.linear() = options.scale * UpToZ(up);
  return Eigen::Translation3d(0.0, 0.0, -options.floor_height) * T;
}

const aiScene* Import(Assimp::Importer& importer, const std::string& path, const MeshOptions& options) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) Fail("{}: cannot open the mesh", path);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, options.up != UpAxis::kFile);
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  const unsigned steps = aiProcess_Triangulate | aiProcess_JoinIdenticalVertices | aiProcess_SortByPType |
                         aiProcess_FindInvalidData;
  const aiScene* scene = nullptr;
  try {
    scene = importer.ReadFile(path, steps);
  } catch (const std::exception& e) {
    Fail("{}: not a mesh that can be read: {}", path, e.what());
  }
  if (scene == nullptr) Fail("{}: not a mesh that can be read: {}", path, importer.GetErrorString());
  if (scene->mRootNode == nullptr || scene->mNumMeshes == 0) Fail("{}: the file holds no triangles", path);
  return scene;
}

TriangleMesh ToMesh(const aiMesh& mesh, const Transform& T, const std::string& path) {
  TriangleMesh result;
  for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
    const aiVector3D& v = mesh.mVertices[i];
    result.vertices.push_back(T * Eigen::Vector3d(v.x, v.y, v.z));
    if (!result.vertices.back().allFinite())
      Fail("{}: vertex {} of {} is not finite", path, i, mesh.mName.C_Str());
  }
  const bool mirrored = T.linear().determinant() < 0.0;
  for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
    const aiFace& face = mesh.mFaces[i];
    if (face.mNumIndices != 3) continue;
    const unsigned a = face.mIndices[0], b = face.mIndices[mirrored ? 2 : 1],
                   c = face.mIndices[mirrored ? 1 : 2];
    if (std::max({a, b, c}) >= mesh.mNumVertices)
      Fail("{}: triangle {} of {} names a vertex that is not there", path, i, mesh.mName.C_Str());
    result.triangles.push_back({a, b, c});
  }
  return result;
}

void AddNode(const aiScene& scene, const aiNode& node, const Transform& T_map_parent,
             const std::string& path, double reflectance, World& world) {
  const Transform T = T_map_parent * ToEigen(node.mTransformation);
  for (unsigned i = 0; i < node.mNumMeshes; ++i) {
    const aiMesh& mesh = *scene.mMeshes[node.mMeshes[i]];
    TriangleMesh triangles = ToMesh(mesh, T, path);
    if (triangles.triangles.empty()) continue;
    const std::string name =
        fmt::format("{}/{} {}", node.mName.C_Str(), mesh.mName.C_Str(), world.bodies.size());
    world.bodies.push_back({name, std::move(triangles), {reflectance}, {}});
  }
  for (unsigned i = 0; i < node.mNumChildren; ++i) {
    AddNode(scene, *node.mChildren[i], T, path, reflectance, world);
  }
}

/// A slab a millimetre below z = 0: where the file has a floor of its own, that one is seen.
Body MakeFloorBelow(const World& world, double reflectance) {
  slam::Box3 box;
  for (const Body& body : world.bodies) {
    for (const Eigen::Vector3d& v : body.mesh_body.vertices) box.extend(v);
  }
  box.min().z() = -0.201;
  box.max().z() = -0.001;
  return {"floor", MakeBox(box), {reflectance}, {}};
}

}  // namespace

bool IsMeshExtension(const std::string& extension) {
  return extension.size() > 1 && Assimp::Importer().IsExtensionSupported(extension);
}

World ReadMeshWorld(const std::string& path, const MeshOptions& options) {
  CheckOptions(options, "mesh.");
  Assimp::Importer importer;
  const aiScene& scene = *Import(importer, path, options);
  World world{std::filesystem::path(path).stem().string(), {}, {}};
  AddNode(scene, *scene.mRootNode, FileToMap(path, options), path, options.reflectance, world);
  if (world.bodies.empty()) Fail("{}: the file holds no triangles", path);
  if (options.floor) world.bodies.push_back(MakeFloorBelow(world, options.reflectance));
  world.T_map_start = {options.start_heading, {options.start_x, options.start_y}};
  return world;
}

}  // namespace ariadne::drivers
