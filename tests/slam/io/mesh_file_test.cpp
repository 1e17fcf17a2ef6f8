#include <gmock/gmock.h>

#include <boost/property_tree/json_parser.hpp>
#include <cstring>
#include <limits>

#include "slam/io/file.h"
#include "slam/io/gltf.h"
#include "slam/io/ply.h"
#include "slam/io/ply_mesh.h"
#include "tests/slam/io/drawings.h"
#include "tests/slam/io/other_programs.h"
#include "tests/slam/io/support.h"

namespace ariadne::slam {
namespace {

using namespace testing_support;
using testing::ElementsAre;
using testing::HasSubstr;

using Write = void (*)(const fs::path&, const TriangleMesh&);
constexpr std::pair<const char*, Write> kWriters[] = {{"mesh.ply", WritePlyMesh}, {"mesh.glb", WriteGlb}};

template <typename T>
T NumberAt(const std::string& bytes, std::size_t offset) {
  T number{};
  std::memcpy(&number, bytes.data() + offset, sizeof(T));
  return number;
}

TEST(PlyMesh, IsReadByAssimp) {
  ARIADNE_REQUIRE_PROGRAM("assimp");
  const TemporaryFolder folder;
  WritePlyMesh(folder / "mesh.ply", ColoredBox());
  const AssimpInfo info = InfoByAssimp(folder / "mesh.ply");
  EXPECT_THAT(info.vertices, ElementsAre(8));
  EXPECT_THAT(info.faces, ElementsAre(12));
  EXPECT_THAT(info.low, ElementsAre(1.0, -1.0, 0.25));
  EXPECT_THAT(info.high, ElementsAre(3.0, 2.0, 1.75));
}

TEST(PlyMesh, IsAPlyFileOfItsVertices) {
  const TemporaryFolder folder;
  TriangleMesh mesh = ColoredBox();
  WritePlyMesh(folder / "mesh.ply", mesh);
  EXPECT_EQ(ReadFile(folder / "mesh.ply", ReadPly).positions, mesh.vertices);
  const std::string bytes = ContentOf(folder / "mesh.ply");
  const std::size_t data = bytes.find("end_header\n") + 11;
  ASSERT_EQ(bytes.size(), data + 8 * 15 + 12 * 13);
  EXPECT_EQ(bytes.substr(data + 15 + 12, 3), "\x1e\x64\xe1");  // the colour of the second vertex
  EXPECT_EQ(NumberAt<std::uint8_t>(bytes, data + 120), 3);
  EXPECT_EQ(NumberAt<std::uint32_t>(bytes, data + 125), 2U);  // the second corner of the first triangle
  mesh.colors.clear();
  WritePlyMesh(folder / "plain.ply", mesh);
  EXPECT_THAT(ContentOf(folder / "plain.ply"), testing::Not(HasSubstr("red")));
  EXPECT_EQ(ReadFile(folder / "plain.ply", ReadPly).positions, mesh.vertices);
}

TEST(Glb, IsReadByAssimp) {
  ARIADNE_REQUIRE_PROGRAM("assimp");
  const TemporaryFolder folder;
  WriteGlb(folder / "mesh.glb", ColoredBox());
  const AssimpInfo info = InfoByAssimp(folder / "mesh.glb");
  EXPECT_THAT(info.vertices, ElementsAre(8));
  EXPECT_THAT(info.faces, ElementsAre(12));
  EXPECT_THAT(info.low, ElementsAre(1.0, 0.25, -2.0));  // y up: (x, z, -y)
  EXPECT_THAT(info.high, ElementsAre(3.0, 1.75, 1.0));
}

TEST(Glb, KeepsItsColorsInAssimp) {
  ARIADNE_REQUIRE_PROGRAM("assimp");
  const TemporaryFolder folder;
  WriteGlb(folder / "mesh.glb", ColoredBox());
  OutputOf("assimp export " + (folder / "mesh.glb").string() + " " + (folder / "read.ply").string());
  // Vertex 0 is (0, 100, 255) in sRGB: (0, 0.1274, 1) linear, which the text of assimp's PLY rounds.
  const std::string text = ContentOf(folder / "read.ply");
  const std::vector<double> vertex = NumbersAfter(text, "end_header\n");
  ASSERT_GE(vertex.size(), 6U) << text.substr(0, 600);
  EXPECT_NEAR(vertex[vertex.size() - 4], 0.0, 1e-9) << text.substr(0, 900);
  EXPECT_NEAR(vertex[vertex.size() - 3], 0.1274 * 255.0, 1.0);
  EXPECT_NEAR(vertex[vertex.size() - 2], 255.0, 1e-9);
}

TEST(Glb, SaysHowItsBytesAreLaidOut) {
  const TemporaryFolder folder;
  WriteGlb(folder / "mesh.glb", ColoredBox());
  const std::string bytes = ContentOf(folder / "mesh.glb");
  const auto json_size = NumberAt<std::uint32_t>(bytes, 12);
  EXPECT_EQ(bytes.substr(0, 4), "glTF");
  EXPECT_EQ(NumberAt<std::uint32_t>(bytes, 4), 2U);
  EXPECT_EQ(NumberAt<std::uint32_t>(bytes, 8), bytes.size());
  EXPECT_EQ(json_size % 4, 0U);
  EXPECT_EQ(NumberAt<std::uint32_t>(bytes, 20 + json_size), bytes.size() - 28 - json_size);
  std::istringstream json(bytes.substr(20, json_size));
  boost::property_tree::ptree tree;
  boost::property_tree::read_json(json, tree);
  EXPECT_EQ(tree.get<std::size_t>("buffers..byteLength"), bytes.size() - 28 - json_size);
  std::size_t end = 0;
  for (const auto& [name, view] : tree.get_child("bufferViews")) {
    EXPECT_EQ(view.get<std::size_t>("byteOffset"), end);
    EXPECT_EQ(end % 4, 0U);
    end += view.get<std::size_t>("byteLength");
  }
  EXPECT_EQ(end, 8U * 12 + 12 * 12 + 8 * 8);
  EXPECT_THAT(json.str(), HasSubstr(R"("min":[1,-1,0.25],"max":[3,2,1.75])"));
}

TEST(Meshes, AreRefusedWhereTheyAreDamaged) {
  const auto damaged = [](const auto& damage) {
    TriangleMesh mesh = ColoredBox();
    damage(mesh);
    return mesh;
  };
  const std::pair<TriangleMesh, const char*> cases[] = {
      {{}, "the mesh has no triangles"},
      {damaged([](TriangleMesh& m) { m.vertices[2].z() = std::numeric_limits<double>::quiet_NaN(); }),
       "vertex 2 is (1, 2, nan) m; a place must be finite and within 1000 km"},
      {damaged([](TriangleMesh& m) { m.vertices[7].x() = 1e40; }), "vertex 7 is (1e+40, 2, 1.75) m; a "},
      {damaged([](TriangleMesh& m) { m.triangles[11][0] = 4000000000U; }),
       "triangle 11 names vertex 4000000000, but there are only 8"},
      {damaged([](TriangleMesh& m) { m.colors.resize(3); }),
       "3 colours for 8 vertices; give one per vertex"}};
  for (const auto& [name, write] : kWriters) {
    const TemporaryFolder folder;
    const fs::path path = folder.Write(name, "old");
    for (const auto& [mesh, sentence] : cases) {
      EXPECT_THAT(ErrorOf([&, w = write, &m = mesh] { w(path, m); }),
                  testing::StartsWith(path.string() + ": cannot be written: " + sentence));
    }
    EXPECT_EQ(ContentOf(path), "old");
  }
}

TEST(Meshes, SayThatTheDiskIsFull) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full here";
  for (const auto& [name, write] : kWriters) {
    const TemporaryFolder folder;
    fs::create_symlink("/dev/full", folder / name);
    EXPECT_THAT(ErrorOf([&, w = write, n = name] { w(folder / n, ColoredBox()); }),
                HasSubstr("cannot be written: No space left on device"));
  }
}

}  // namespace
}  // namespace ariadne::slam
