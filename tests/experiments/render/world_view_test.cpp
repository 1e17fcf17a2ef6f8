#include "experiments/render/world_view.h"

#include <gtest/gtest.h>

#include "tests/drivers/simulated/box_room.h"

namespace ariadne::experiments {
namespace {

/// A cube of 2 m on the ground, from above at 50 px/m in a picture of 200 x 200 px: its corners are at 50,
/// 150.
drivers::RayScene Cube() {
  drivers::World world;
  world.bodies.push_back(drivers::BoxBody("cube", {-1.0, -1.0, 0.0}, {1.0, 1.0, 2.0}, 1.0));
  return drivers::RayScene(std::move(world));
}

Camera FromAbove() { return TopView({200, 200}, Up::kPlusY, Eigen::Vector3d::Zero(), 50.0); }

TEST(RenderWorld, ShowsSurfacesWhereTheyAre) {
  const Image image = RenderWorld(Cube(), FromAbove(), {.background = kBlack}, Parallel(1));
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const bool inside = x >= 50 && x < 150 && y >= 50 && y < 150;
      ASSERT_EQ(image.At(x, y) != kBlack, inside) << x << ", " << y;
    }
  }
}

TEST(RenderWorld, IsDarkWhereItCutsASolidOpen) {
  const WorldViewOptions cut{.cut_height = 1.0};
  EXPECT_EQ(RenderWorld(Cube(), FromAbove(), cut, Parallel(1)).At(100, 100), cut.cut);
  const WorldViewOptions above{.cut_height = 2.5};
  EXPECT_NE(RenderWorld(Cube(), FromAbove(), above, Parallel(1)).At(100, 100), above.cut);
}

TEST(RenderWorld, LooksIntoARoomWithoutItsCeiling) {
  drivers::World world = drivers::EmptyRoom({-2.0, -2.0, 0.0}, {2.0, 2.0, 2.7});
  const Eigen::Vector3d lowest(-2.0, -2.0, -0.1), highest(2.0, 2.0, 0.0);  // of its floor
  world.bodies[0].mesh_body = drivers::MakeBox(slam::Box3(lowest, highest));
  const drivers::RayScene scene(std::move(world));
  const Image image =
      RenderWorld(scene, FromAbove(), {.cut_height = 1.0, .background = kBlack}, Parallel(1));
  EXPECT_NE(image.At(100, 100), kBlack);
}

TEST(RenderWorld, SeesInPerspective) {
  const Camera camera = LookAt({-5.0, 0.0, 1.0}, {0.0, 0.0, 1.0}, {0.0, 0.0, 1.0}, 1.0, {200, 200});
  const Image image = RenderWorld(Cube(), camera, {.background = kBlack}, Parallel(1));
  const double half = 1.0 / 4.0 * camera.scale;  // the front is 2 m wide, and 4 m away
  EXPECT_NE(image.At(100 + static_cast<int>(half) - 2, 100), kBlack);
  EXPECT_EQ(image.At(100 + static_cast<int>(half) + 2, 100), kBlack);
}

TEST(RenderWorld, DoesNotDependOnThreads) {
  EXPECT_EQ(RenderWorld(Cube(), FromAbove(), {}, Parallel(1)),
            RenderWorld(Cube(), FromAbove(), {}, Parallel(2)));
}

}  // namespace
}  // namespace ariadne::experiments
