#include "slam/map/surface_model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_of.h"

namespace ariadne::slam {
namespace {

/// A rectangle of that width (level) and height around a place, with this normal and a hole of 0.5 m.
PlanarSurface RectangleWithHole(const Eigen::Vector3d& center, const Eigen::Vector3d& normal, double width,
                                double height) {
  const double w = 0.5 * width, h = 0.5 * height;
  PlanarSurface surface;
  surface.T_frame_plane = PlaneFrame(center, normal);
  surface.outlines = {{{{-w, -h}, {w, -h}, {w, h}, {-w, h}},
                       {{{-0.25, -0.25}, {-0.25, 0.25}, {0.25, 0.25}, {0.25, -0.25}}}}};
  surface.points = 100;
  return surface;
}

/// A floor, a wall and a person's chest.
std::vector<PlanarSurface> Scene() {
  return {RectangleWithHole({3, 0, -1.0}, Eigen::Vector3d::UnitZ(), 6.0, 4.0),
          RectangleWithHole({6, 0, 0.35}, -Eigen::Vector3d::UnitX(), 4.0, 2.7),
          RectangleWithHole({4, 1, 0.1}, -Eigen::Vector3d::UnitX(), 0.6, 0.8)};
}

double AreaOfTriangles(const TriangleMesh& mesh) {
  double area = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Eigen::Vector3d& p = mesh.vertices[a];
    area += 0.5 * (mesh.vertices[b] - p).cross(mesh.vertices[c] - p).norm();
  }
  return area;
}

TEST(SurfaceModel, TellsFloorWallsAndObjects) {
  const SurfaceModel model = MakeSurfaceModel(Scene(), {});
  EXPECT_THAT(model.classes, testing::UnorderedElementsAre(SurfaceClass::kFloor, SurfaceClass::kWall,
                                                           SurfaceClass::kObject));
  EXPECT_NEAR(FloorHeight(model).value(), -1.0, 1e-12);
  ASSERT_EQ(model.objects.size(), 1U);
  EXPECT_EQ(FloorHeight(MakeSurfaceModel({}, {})), std::nullopt);
}

TEST(SurfaceModel, HasTrianglesThatFaceTheSeenSideAndLeaveHolesOpen) {
  for (const PlanarSurface& surface : Scene()) {
    const TriangleMesh mesh = MeshOf(surface, {1, 2, 3});
    EXPECT_NEAR(AreaOfTriangles(mesh), Area(surface), 1e-3);
    EXPECT_EQ(mesh.colors.size(), mesh.vertices.size());
    for (const auto& [a, b, c] : mesh.triangles) {
      const Eigen::Vector3d& p = mesh.vertices[a];
      const Eigen::Vector3d normal = (mesh.vertices[b] - p).cross(mesh.vertices[c] - p).normalized();
      EXPECT_GT(normal.dot(PlaneOf(surface).normal), 0.999);
    }
  }
}

TEST(SurfaceModel, IsDrawnInALayerPerClass) {
  const Drawing drawing = DrawingOf(MakeSurfaceModel(Scene(), {}));
  std::vector<std::string> names;
  for (const DrawingLayer& layer : drawing.layers) names.push_back(layer.name);
  EXPECT_THAT(names, testing::ElementsAre("floor", "ceiling", "wall", "object", "boxes"));
  EXPECT_EQ(drawing.layers[0].lines.size(), 2U) << "outline and hole";
  EXPECT_TRUE(drawing.layers[1].mesh.triangles.empty());
  EXPECT_EQ(drawing.layers[4].lines.size(), 6U) << "two rings and four uprights";
}

TEST(SurfaceModel, FromLinesNeedsSlices) {
  const PosedCloud blind{"scan7", {{{1, 0, 0}, {1, 1, 0}}, {}, {}, {}}, Pose3()};
  EXPECT_THAT(ErrorOf([&] { SurfacesInMap(blind, {}); }),
              testing::StartsWith("scan7: surfaces from lines need the slices"));
}

}  // namespace
}  // namespace ariadne::slam
