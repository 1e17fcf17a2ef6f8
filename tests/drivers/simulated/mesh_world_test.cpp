#include "drivers/simulated/mesh_world.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "drivers/simulated/ray_scene.h"
#include "slam/base/error.h"
#include "slam/base/random.h"
#include "slam/geometry/box3.h"

namespace ariadne::drivers {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;

/// A folder of this test that is removed with it.
class MeshWorld : public testing::Test {
 protected:
  MeshWorld()
      : folder_(std::filesystem::temp_directory_path() / ("mesh_world_" + std::to_string(::getpid()))) {
    std::filesystem::create_directories(folder_);
  }
  ~MeshWorld() override { std::filesystem::remove_all(folder_); }

  std::string Write(const std::string& name, const std::string& text) const {
    const std::string path = (folder_ / name).string();
    std::ofstream(path, std::ios::binary) << text;
    return path;
  }

  static slam::Box3 BoxOf(const World& world) {
    return slam::BoxAround(world.bodies.front().mesh_body.vertices);
  }

  static std::string ErrorOf(const std::string& path, const MeshOptions& options = {}) {
    try {
      ReadMeshWorld(path, options);
    } catch (const Error& e) {
      return e.what();
    }
    return "no error";
  }

 private:
  std::filesystem::path folder_;
};

constexpr const char* kObj = "v 0 0 0\nv 1 0 0\nv 1 2 3\nf 1 2 3\n";

/// A triangle (0 0 0), (10 0 0), (10 20 30) in a node that is moved by 100 along x, in centimetres.
std::string Collada(const std::string& up) {
  return R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit meter="0.01" name="centimeter"/><up_axis>)" +
         up + R"(</up_axis></asset><library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="a" count="9">0 0 0 10 0 0 10 20 30</float_array><technique_common>
<accessor source="#a" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles>
</mesh></geometry></library_geometries><library_visual_scenes><visual_scene id="s">
<node id="n" name="n"><translate>100 0 0</translate><instance_geometry url="#g"/></node></visual_scene>
</library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
}

TEST_F(MeshWorld, TakesMetresAndZUpWhereTheFileSaysNothing) {
  const World world = ReadMeshWorld(Write("a.obj", kObj));
  EXPECT_TRUE(BoxOf(world).isApprox(slam::Box3(Vector3d(0, 0, 0), Vector3d(1, 2, 3)), 1e-6));
  EXPECT_EQ(world.name, "a");
  ASSERT_EQ(world.bodies.size(), 2u);
  EXPECT_EQ(world.bodies.back().name, "floor");
}

TEST_F(MeshWorld, HonoursScaleAxisFloorAndStart) {
  MeshOptions options;
  options.scale = 0.5;
  options.up = UpAxis::kY;
  options.floor = false;
  options.floor_height = 0.25;
  options.start_x = 3.0;
  const World world = ReadMeshWorld(Write("a.obj", kObj), options);
  EXPECT_TRUE(BoxOf(world).isApprox(slam::Box3(Vector3d(0, -1.5, -0.25), Vector3d(0.5, 0, 0.75)), 1e-6));
  EXPECT_EQ(world.bodies.size(), 1u);
  EXPECT_EQ(world.T_map_start.translation.x(), 3.0);
  options.up = UpAxis::kX;
  EXPECT_NEAR(BoxOf(ReadMeshWorld(Write("a.obj", kObj), options)).sizes().z(), 0.5, 1e-6);
}

TEST_F(MeshWorld, HonoursUnitAxisAndNodesOfCollada) {
  const slam::Box3 z_up = BoxOf(ReadMeshWorld(Write("z.dae", Collada("Z_UP"))));
  EXPECT_TRUE(z_up.isApprox(slam::Box3(Vector3d(1, 0, 0), Vector3d(1.1, 0.2, 0.3)), 1e-6))
      << z_up.min().transpose() << " " << z_up.max().transpose();
  const slam::Box3 y_up = BoxOf(ReadMeshWorld(Write("y.dae", Collada("Y_UP"))));
  EXPECT_TRUE(y_up.isApprox(slam::Box3(Vector3d(1, -0.3, 0), Vector3d(1.1, 0, 0.2)), 1e-6))
      << y_up.min().transpose() << " " << y_up.max().transpose();
  MeshOptions options;
  options.up = UpAxis::kZ;
  const slam::Box3 told = BoxOf(ReadMeshWorld(Write("y.dae", Collada("Y_UP")), options));
  EXPECT_TRUE(told.isApprox(slam::Box3(Vector3d(1, 0, 0), Vector3d(1.1, 0.2, 0.3)), 1e-6))
      << "told otherwise";
}

TEST_F(MeshWorld, ReadsStlAndPly) {
  const std::string stl =
      "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
      "0\nendloop\nendfacet\nendsolid a\n";
  EXPECT_NEAR(BoxOf(ReadMeshWorld(Write("a.stl", stl))).sizes().y(), 1.0, 1e-6);
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n2 0 0\n2 1 0\n0 1 0\n4 0 "
      "1 2 3\n";
  const World world = ReadMeshWorld(Write("a.ply", ply));
  EXPECT_EQ(world.bodies.front().mesh_body.triangles.size(), 2u) << "a quadrilateral is two triangles";
}

TEST_F(MeshWorld, SaysWhatCannotBeRead) {
  EXPECT_THAT(ErrorOf("/nowhere/a.obj"), HasSubstr("/nowhere/a.obj: cannot open the mesh"));
  EXPECT_THAT(ErrorOf(Write("empty.dae", "")), HasSubstr("empty.dae: not a mesh that can be read"));
  EXPECT_THAT(ErrorOf(Write("broken.dae", "<COLLADA><asset>")), HasSubstr("broken.dae: "));
  EXPECT_THAT(ErrorOf(Write("points.obj", "v 0 0 0\nv 1 0 0\n")), HasSubstr("points.obj: "));
  MeshOptions options;
  options.scale = 0.0;
  EXPECT_THAT(ErrorOf(Write("a.obj", kObj), options), HasSubstr("mesh.scale is 0"));
}

TEST_F(MeshWorld, SurvivesDamagedFiles) {
  RandomStream stream = NamedStream(8, "damage");
  for (const auto& [name, whole] :
       {std::pair<std::string, std::string>{"d.dae", Collada("Z_UP")}, {"d.obj", kObj}}) {
    for (int round = 0; round < 60; ++round) {
      std::string text = whole;
      text[stream() % text.size()] = static_cast<char>("<>/\"0 -e\n"[stream() % 9]);
      if (round % 2 == 0) text.resize(stream() % text.size());
      const std::string error = ErrorOf(Write(name, text));
      EXPECT_TRUE(error == "no error" || error.find(name) != std::string::npos) << error;
    }
  }
}

TEST(IsMeshExtension, KnowsAssimpsFormats) {
  for (const char* extension : {".dae", ".obj", ".stl", ".ply"}) EXPECT_TRUE(IsMeshExtension(extension));
  for (const char* extension : {"", ".", ".txt", ".yaml"})
    EXPECT_FALSE(IsMeshExtension(extension)) << extension;
}

TEST(ReadMeshWorld, ReadsTheWorldsOfTheDataSet) {
  const char* data = std::getenv("ARIADNE_DATA");
  if (data == nullptr || !std::filesystem::exists(std::string(data) + "/worlds")) {
    GTEST_SKIP() << "needs the worlds: ARIADNE_DATA is not set to a folder with worlds/";
  }
  const std::string worlds = std::string(data) + "/worlds";
  const RayScene garage(ReadMeshWorld(worlds + "/willowgarage/meshes/willowgarage_collision.dae"));
  slam::Box3 box;
  for (const Body& body : garage.world().bodies) box.extend(slam::BoxAround(body.mesh_body.vertices));
  EXPECT_NEAR(box.sizes().x(), 58.6, 0.1) << "inches were made metres";
  EXPECT_NEAR(box.max().z(), 2.845, 0.01) << "and z is up";
  EXPECT_EQ(ReadMeshWorld(worlds + "/nbv_flat/mesh/meshFlat.stl").bodies.front().mesh_body.triangles.size(),
            396u);
}

}  // namespace
}  // namespace ariadne::drivers
