#include "slam/extract/objects.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "drivers/simulated/ais_scanner.h"
#include "drivers/simulated/load_world.h"
#include "slam/extract/extract_surfaces.h"
#include "tests/support/error_of.h"

namespace ariadne::slam {
namespace {

/// A rectangle of that width (level) and height around a place, with this normal.
PlanarSurface Rectangle(const Eigen::Vector3d& center, const Eigen::Vector3d& normal, double width,
                        double height) {
  const double w = 0.5 * width, h = 0.5 * height;
  PlanarSurface surface;
  surface.T_frame_plane = PlaneFrame(center, normal);
  surface.outlines = {{{{-w, -h}, {w, -h}, {w, h}, {-w, h}}, {}}};
  return surface;
}

const Eigen::Vector3d kAhead = Eigen::Vector3d::UnitX(), kUp = Eigen::Vector3d::UnitZ();

/// The far wall of a room of 6 x 4 x 2.7 m, its floor and its ceiling.
std::vector<PlanarSurface> SurfacesOfRoom() {
  return {Rectangle({6, 0, 1.35}, -kAhead, 4.0, 2.7), Rectangle({3, 0, 0}, kUp, 6.0, 4.0),
          Rectangle({3, 0, 2.7}, -kUp, 6.0, 4.0)};
}

SurfaceClass ClassOf(const PlanarSurface& surface) {
  std::vector<PlanarSurface> surfaces = SurfacesOfRoom();
  surfaces.push_back(surface);
  return ClassifySurfaces(surfaces, {}).back();
}

TEST(ClassifySurfaces, TellsStructureFromThings) {
  EXPECT_THAT(ClassifySurfaces(SurfacesOfRoom(), {}),
              testing::ElementsAre(SurfaceClass::kWall, SurfaceClass::kFloor, SurfaceClass::kCeiling));
  EXPECT_EQ(ClassOf(Rectangle({2, 1, 0.02}, kUp, 1, 1)), SurfaceClass::kFloor);             // a rug
  EXPECT_EQ(ClassOf(Rectangle({2, 1, 0.74}, kUp, 1.6, 0.8)), SurfaceClass::kObject);        // a table,
  EXPECT_EQ(ClassOf(Rectangle({2, 1, 0.70}, -kUp, 1.6, 0.8)), SurfaceClass::kObject);       // from below
  EXPECT_EQ(ClassOf(Rectangle({2, 1, 2.3}, -kUp, 4.0, 0.3)), SurfaceClass::kCeiling);       // a beam
  EXPECT_EQ(ClassOf(Rectangle({5.5, 1, 0.95}, -kAhead, 1.2, 1.9)), SurfaceClass::kObject);  // a cupboard
  EXPECT_EQ(ClassOf(Rectangle({4, 1, 1.35}, -kAhead, 1.2, 2.7)), SurfaceClass::kWall);      // of a niche
  EXPECT_EQ(ClassOf(Rectangle({5.9, 1, 1.0}, -kAhead, 0.9, 2.0)), SurfaceClass::kWall);     // a door
  EXPECT_EQ(ClassOf(Rectangle({4, 1, 1.2}, -kAhead, 0.4, 1.2)), SurfaceClass::kObject);     // a person
}

TEST(SegmentObjects, MergesBoxesBetweenWhichTheRobotDoesNotFit) {
  std::vector<PlanarSurface> surfaces = SurfacesOfRoom();
  surfaces.push_back(Rectangle({3.0, 0.0, 0.5}, -kAhead, 0.4, 1.0));
  surfaces.push_back(Rectangle({3.0, 0.9, 0.5}, -kAhead, 0.4, 1.0));   // 0.5 m between them
  surfaces.push_back(Rectangle({3.0, -1.2, 0.5}, -kAhead, 0.4, 1.2));  // 0.8 m
  const std::vector<ObjectBox> objects = SegmentObjects(surfaces, {});
  ASSERT_EQ(objects.size(), 2u);
  EXPECT_THAT(objects[0].surfaces, testing::ElementsAre(3, 4));
  EXPECT_TRUE(objects[0].box.isApprox(Box3(Eigen::Vector3d(3, -0.2, 0), Eigen::Vector3d(3, 1.1, 1))));
  ObjectOptions wide;
  wide.robot_size = 0.9;
  EXPECT_EQ(SegmentObjects(surfaces, wide).size(), 1u);
}

TEST(SegmentObjects, DrivesBelowWhatHangsHigh) {
  std::vector<PlanarSurface> surfaces = SurfacesOfRoom();
  surfaces.push_back(Rectangle({2.0, 1.0, 0.5}, -kAhead, 0.4, 1.0));
  surfaces.push_back(Rectangle({3.5, 1.0, 0.5}, -kAhead, 0.4, 1.0));
  surfaces.push_back(Rectangle({2.7, 1.0, 1.8}, Eigen::Vector3d::UnitY(), 3.0, 0.3));  // a beam above both
  surfaces.push_back(Rectangle({2.05, 1.0, 1.6}, -kAhead, 0.3, 0.4));  // the head of the first
  const std::vector<ObjectBox> objects = SegmentObjects(surfaces, {});
  ASSERT_EQ(objects.size(), 2u);
  EXPECT_THAT(objects[0].surfaces, testing::ElementsAre(3, 6));
  EXPECT_THAT(objects[1].surfaces, testing::ElementsAre(4));
  ObjectOptions tall;
  tall.robot_height = 2.5;
  EXPECT_EQ(SegmentObjects(surfaces, tall).size(), 1u) << "the beam joins them";
}

TEST(SegmentObjects, LeavesOutWhatIsSmallAndTakesNothing) {
  EXPECT_TRUE(SegmentObjects({}, {}).empty());
  EXPECT_TRUE(SegmentObjects(SurfacesOfRoom(), {}).empty());
  const std::vector<PlanarSurface> speck{Rectangle({3.0, 0.0, 0.5}, -kAhead, 0.2, 0.2)};
  EXPECT_TRUE(SegmentObjects(speck, {}).empty());
  ObjectOptions wrong;
  wrong.robot_size = -1.0;
  EXPECT_THAT(ErrorOf([&] { SegmentObjects(SurfacesOfRoom(), wrong); }),
              testing::HasSubstr("objects.robot_size"));
}

// Fig. 2.
TEST(SegmentObjects, FindsTwoPersonsInTheCorridor) {
  const drivers::RayScene scene(drivers::LoadWorld("builtin:robobench"));
  const drivers::AisScannerOptions options;
  const Pose3 T_map_base = ToPose3({0.0, Eigen::Vector2d(2.6, 0.0)});
  const Pose3 T_map_laser = T_map_base * drivers::AisMounting(options).T_base_laser;
  const Scan scan = drivers::TakeAisScan(scene, T_map_base, 0.0, options, 1, 0, Parallel(1));
  for (const SurfaceMethod method : {SurfaceMethod::kLines, SurfaceMethod::kRegionGrowing}) {
    ExtractSurfacesOptions extract;
    extract.method = method;
    std::vector<PlanarSurface> surfaces = ExtractSurfaces(ToPointCloud(scan), extract);
    for (PlanarSurface& surface : surfaces) surface = Transformed(T_map_laser, surface);
    const std::vector<ObjectBox> objects = SegmentObjects(surfaces, {});
    std::vector<const ObjectBox*> boxes;
    for (const Eigen::Vector3d& person :
         {Eigen::Vector3d(5.5, 0.74, 1.2), Eigen::Vector3d(6.5, -0.72, 1.2)}) {
      for (const ObjectBox& object : objects) {
        if (object.box.exteriorDistance(person) < 0.2) boxes.push_back(&object);
      }
    }
    ASSERT_EQ(boxes.size(), 2u) << NameOf(method);
    EXPECT_NE(boxes[0], boxes[1]);
    for (const ObjectBox* box : boxes) {
      EXPECT_LT(box->box.sizes().x(), 1.0);
      EXPECT_LT(box->box.sizes().y(), 1.0);
      EXPECT_LT(box->box.max().z(), 2.1);
    }
  }
}

}  // namespace
}  // namespace ariadne::slam
