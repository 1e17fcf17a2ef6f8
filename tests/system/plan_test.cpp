// plan: from a registered run to the next view.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/system/program.h"

namespace ariadne {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class PlanTest : public ProgramTest {
 protected:
  void Register() const {
    Must(
        "register builtin:tour --set input.tour.scans=2 --set input.tour.scanner.slices=96 "
        "--set output.figures=false -q --out run");
  }
};

TEST_F(PlanTest, TellsAndDrawsTheNextViewTheSameEveryTime) {
  Register();
  const std::string text = Must("plan run -q");
  EXPECT_THAT(text, HasSubstr("next view: ("));
  EXPECT_THAT(text, HasSubstr("m unseen"));
  const nlohmann::json view = nlohmann::json::parse(Content("run/plan/next_view.json"));
  EXPECT_EQ(view["status"], "found");
  EXPECT_EQ(view["scans"], 2);
  EXPECT_GT(view["gain_rays"], 0);
  EXPECT_GT(view["unseen_m"], 1.0);
  EXPECT_NEAR(view["slice_z"], 1.5, 0.05) << "the tour's floor is z = 0";
  EXPECT_THAT(Content("run/plan/plan.svg"), HasSubstr("layer_unseen"));
  EXPECT_THAT(Content("run/plan/figures/plan.png"), StartsWith("\x89PNG"));
  Must("plan run -q --out again");
  for (const char* file : {"next_view.json", "plan.svg", "figures/plan.png"})
    EXPECT_TRUE(Content(std::string("run/plan/") + file) == Content(std::string("again/") + file)) << file;
}

/// Three scans of a real hallway, whose floor is at no round height.
TEST_F(PlanTest, PlansOnRealScans) {
  const fs::path data = slam::testing_support::DataFolder();
  ARIADNE_REQUIRE_DATA(data / "scans/hallway");
  setenv("ARIADNE_DATA", data.c_str(), 1);
  Must("run '" ARIADNE_SOURCE_DIR
       "/experiments/configs/hallway.yaml' --set reduce.method=voxel_mean "
       "--set reduce.voxel_size=0.1 --set output.map=false --set output.figures=false -q --out run");
  Must("plan run -q");
  const nlohmann::json view = nlohmann::json::parse(Content("run/plan/next_view.json"));
  EXPECT_EQ(view["status"], "found");
  EXPECT_EQ(view["scans"], 3);
  EXPECT_GT(view["seen_m"], 10.0) << "walls of the hallway";
  EXPECT_GT(view["gain_rays"], 30);
  EXPECT_GT(view["distance_m"], 0.5);
  const auto& path = view["path_map"];
  ASSERT_GE(path.size(), 2U);
  EXPECT_EQ(path.back()[0], view["pose_map"]["x"]);
  Must("plan run -q --out again");
  EXPECT_TRUE(Content("run/plan/next_view.json") == Content("again/next_view.json"));
}

TEST_F(PlanTest, WhatCannotBeIsSaid) {
  EXPECT_THAT(Ariadne("plan none -q").err, HasSubstr("none/config.yaml"));
  Register();
  EXPECT_EQ(Ariadne("plan run -q --set height=900").err,
            "ariadne: the scans show nothing at the height of 900 m\n");
  EXPECT_THAT(Ariadne("plan run -q --set step.height=1 --out other").err, HasSubstr("unknown key"));
  EXPECT_THAT(Must("plan --help"), HasSubstr("Example:\n  ariadne plan results/garage"));
}

}  // namespace
}  // namespace ariadne
