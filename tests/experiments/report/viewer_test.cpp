#include "experiments/report/viewer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ariadne::experiments {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;
using testing::Not;

slam::PosedCloud ScanAt(double x, bool with_reflectance) {
  slam::PosedCloud scan{"scan", {}, {Eigen::Quaterniond::Identity(), {x, 0, 0}}};
  scan.cloud_laser.positions = {{1, 0, 0}, {0, 1, 0}};
  if (with_reflectance) scan.cloud_laser.reflectance = {1.0F, 2.0F};
  return scan;
}

TEST(SceneOf, PutsScansIntoTheMap) {
  const std::vector<slam::PosedCloud> scans{ScanAt(0, true), ScanAt(5, true)};
  const ViewerScene scene = SceneOf(scans);
  ASSERT_EQ(scene.points.size(), 4U);
  EXPECT_EQ(scene.points[2].p_map, Eigen::Vector3f(6, 0, 0));
  EXPECT_EQ(scene.points[3].stop, 1U);
  EXPECT_EQ(scene.points[3].reflectance, 2.0F);
  EXPECT_EQ(scene.stops[1].step, 1U);
  ASSERT_EQ(scene.driven.size(), 1U);
  EXPECT_EQ(scene.driven[0].points_map[1], Eigen::Vector3d(5, 0, 0));
  EXPECT_TRUE(scene.has_reflectance);
}

TEST(SceneOf, HasReflectanceWhereAllScansHave) {
  for (const bool first : {false, true}) {
    const std::vector<slam::PosedCloud> scans{ScanAt(0, first), ScanAt(1, !first), ScanAt(2, true)};
    EXPECT_FALSE(SceneOf(scans).has_reflectance);
  }
}

TEST(ViewerSection, OfNothingIsASentence) {
  EXPECT_THAT(ViewerSection({}).html, MatchesRegex("<p>There is nothing to show [^<]*</p>\n"));
}

TEST(ViewerSection, NeedsNothingFromElsewhere) {
  if (!HasViewer()) GTEST_SKIP() << "built without npm";
  const std::vector<slam::PosedCloud> scans{ScanAt(0, true)};
  const std::string html = ViewerSection(SceneOf(scans)).html;
  EXPECT_EQ(html, ViewerSection(SceneOf(scans)).html);
  for (const char* request : {" src=", "href=", "@import", "import("})
    EXPECT_THAT(html, Not(HasSubstr(request)));
  EXPECT_THAT(html, HasSubstr("Permission is hereby granted")) << "the licence of three.js goes along";
  EXPECT_THAT(html, Not(HasSubstr(ARIADNE_SOURCE_DIR)));
}

}  // namespace
}  // namespace ariadne::experiments
