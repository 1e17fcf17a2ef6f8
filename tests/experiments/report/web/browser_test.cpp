#include <gtest/gtest.h>

#include "experiments/report/viewer.h"
#include "tests/experiments/report/web/check_page.h"
#include "tests/slam/io/support.h"

namespace ariadne::experiments {
namespace {

/// Two scans of a room of 8 x 6 x 2.5 m, one at each end.
ViewerScene RoomScene() {
  std::vector<slam::PosedCloud> scans;
  for (const double x : {-3.0, 3.0}) {
    slam::PosedCloud scan{x < 0 ? "west" : "east", {}, {Eigen::Quaterniond::Identity(), {x, 0.0, 1.0}}};
    for (double u = -3.0; u <= 3.0; u += 0.05) {
      for (double z = -1.0; z <= 1.5; z += 0.05) {
        scan.cloud_laser.positions.push_back({u, 3.0, z});
        scan.cloud_laser.positions.push_back({x / 3.0, u, z});
        scan.cloud_laser.positions.push_back({u, 2.0 * z, -1.0});
        for (int i = 0; i < 3; ++i) scan.cloud_laser.reflectance.push_back(static_cast<float>(u * i + z));
      }
    }
    scans.push_back(scan);
  }
  return SceneOf(scans);
}

/// The room with everything that a view can show.
ViewerScene FullScene() {
  ViewerScene scene = RoomScene();
  scene.boxes.push_back({slam::Box3(Eigen::Vector3d(-1, -1, 0), Eigen::Vector3d(0, 0, 0.8)),
                         {Eigen::Quaterniond(Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitZ())), {1, 0, 0}},
                         1});
  scene.planned.push_back({{{-3, 0, 0}, {0, -2, 0}, {3, 0, 0}}, 0});
  scene.planned.push_back({{{3, 0, 0}, {3, 2, 0}}, 1});
  scene.polygons.push_back(
      {{{{{-4, -3}, true}, {{4, -3}, false}, {{4, 3}, true}, {{-4, 3}, true}}, {}}, 0.9, 0});
  scene.mesh_map = {{{-4, 2, 0}, {4, 2, 0}, {4, 2, 1.5}, {-4, 2, 1.5}},
                    {{0, 1, 2}, {0, 2, 3}},
                    {{200, 80, 80}, {80, 200, 80}, {80, 80, 200}, {200, 200, 80}}};
  return scene;
}

TEST(PageInBrowser, ShowsTheSceneAndObeysItsControls) {
  if (const std::string reason = NoBrowser(); !reason.empty()) GTEST_SKIP() << reason;
  const slam::testing_support::TemporaryFolder folder;
  CheckPageInBrowser(folder.Write("a page.html", ToHtml({"room", {ViewerSection(FullScene())}, {}})));
}

}  // namespace
}  // namespace ariadne::experiments
