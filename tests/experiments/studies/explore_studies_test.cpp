// What an exploration leaves of each step and of all together, and the figures that are drawn of it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/report/table.h"
#include "experiments/studies/explore_pictures.h"
#include "experiments/studies/explored_run.h"
#include "slam/io/file.h"
#include "tests/experiments/studies/small_office.h"
#include "tests/support/error_of.h"

namespace ariadne::experiments {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

ExploredStep SomeStep() {
  ExploredStep step;
  step.index = 1;
  step.registered = false;
  step.T_map_stops = {{0.0, {0.0, 0.0}}, {1.5, {2.0, -0.25}}};
  step.driven_map = {{0.0, 0.0}, {1.0, 0.0}, {2.0, -0.25}};
  step.area = {{{{{-1.0, -1.0}, true}, {{3.0, -1.0}, false}, {{3.0, 2.0}, true}, {{-1.0, 2.0}, true}},
                {{{{1.0, 0.5}, true}, {{1.0, 1.0}, true}, {{1.5, 0.5}, false}}}}};
  step.obstacles_map = {{0.5, 0.5}};
  step.view = planning::View{.p_map = {2.5, 1.0}, .direction = 0.5, .gain = 17, .distance = 1.5};
  step.planned_map = {{1.5, {2.0, -0.25}}, {0.5, {2.5, 1.0}}};
  step.leg_only = true;
  return step;
}

TEST(ExploredStep, ComesBackFromItsFile) {
  const Json json = ToJson(SomeStep());
  const ExploredStep again = StepFromJson(Json::parse(json.dump()), "step");
  EXPECT_EQ(ToJson(again), json);
  EXPECT_EQ(again.T_map_base().translation, Eigen::Vector2d(2.0, -0.25));
  EXPECT_EQ(again.view->gain, 17);
  EXPECT_TRUE(again.leg_only);
  EXPECT_FALSE(again.of_disc);
  EXPECT_FALSE(again.registered);
  ASSERT_EQ(again.area.size(), 1U);
  EXPECT_FALSE(again.area[0].outer[1].seen);
  EXPECT_EQ(again.area[0].holes[0][2].p_map, Eigen::Vector2d(1.5, 0.5));
}

TEST(ExploredStep, WithoutAWayToItsViewComesBackToo) {
  ExploredStep step = SomeStep();
  step.view->distance = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(std::isinf(StepFromJson(Json::parse(ToJson(step).dump()), "step").view->distance));
  step.view.reset();
  EXPECT_FALSE(StepFromJson(ToJson(step), "step").view.has_value());
}

TEST(ExploredStep, FromAnythingElseIsAnError) {
  Json json = ToJson(SomeStep());
  json["scan"] = 7;
  EXPECT_EQ(ErrorOf([&] { StepFromJson(json, "a.json"); }), "a.json: scan 7 with 2 stops");
  json.erase("area_m_seen");
  EXPECT_EQ(ErrorOf([&] { StepFromJson(json, "a.json"); }), "a.json: this is not a step of a mission");
  EXPECT_THAT(ErrorOf([&] { StepFromJson(Json::parse("[1", nullptr, false), "b"); }), StartsWith("b: "));
}

const slam::DrawingLayer& Layer(const slam::Drawing& drawing, const std::string& name) {
  return *std::ranges::find(drawing.layers, name, &slam::DrawingLayer::name);
}

double LengthOf(const slam::DrawingLayer& layer) {
  double length = 0.0;
  for (const slam::Polyline3& line : layer.lines) {
    for (std::size_t i = 1; i < line.points.size(); ++i)
      length += (line.points[i] - line.points[i - 1]).norm();
  }
  return length;
}

TEST(ExploredStep, IsDrawnWithAllThatItKnows) {
  const ExploredStep step = SomeStep();
  const slam::Drawing drawing = DrawingOf(step, step.driven_map);
  const double sample = 1.0;  // of the legend
  EXPECT_NEAR(LengthOf(Layer(drawing, "seen")), 4.0 + 4.0 + 3.0 + 0.5 + std::sqrt(0.5) + sample, 1e-9);
  EXPECT_NEAR(LengthOf(Layer(drawing, "driven")), 1.0 + std::hypot(1.0, 0.25) + sample, 1e-9);
  const double dashes = LengthOf(Layer(drawing, "unseen"));
  EXPECT_GT(dashes, 0.5 * 3.5);
  EXPECT_LT(dashes, 0.8 * 3.5 + sample);
  EXPECT_EQ(Layer(drawing, "obstacles").points.size(), 1U + 11U);
  EXPECT_FALSE(Layer(drawing, "next_view").lines.empty());
  EXPECT_FALSE(Layer(drawing, "stops").lines.empty()) << "the first, which is 2 m away";
  ExploredStep last = step;
  last.view.reset();
  last.planned_map.clear();
  EXPECT_TRUE(Layer(DrawingOf(last, step.driven_map), "next_view").lines.empty());
  EXPECT_TRUE(Layer(DrawingOf(last, step.driven_map), "planned").lines.empty());
}

TEST(StepsHtml, ShowsTheLastAndReachesAll) {
  EXPECT_EQ(StepsHtml(0), "");
  const std::string html = StepsHtml(12);
  EXPECT_THAT(html, HasSubstr("max=\"11\" value=\"11\""));
  EXPECT_THAT(html, HasSubstr("src=\"steps/step011.svg\""));
}

class ExploreStudyTest : public StudyTest {
 protected:
  /// Two rooms, coarse scans, three of them.
  OptionEntries Quick(const std::string& section = "") {
    slam::WriteFileAtomically(folder_ / "rooms.json", [](std::ostream& out) {
      out << R"({"walls": [[0, 0, 8, 0], [8, 0, 8, 4], [8, 4, 0, 4], [0, 4, 0, 0], [4, 0, 4, 1.2],
                           [4, 2.8, 4, 4], [1.2, 4, 1.2, 3.2]],
                 "doors": [], "start": [1.5, 2.0], "spaces": []})";
    });
    OptionEntries entries;
    entries.Set(section + "world=" + (folder_ / "rooms.json").string());
    for (const char* assignment :
         {"robot.ais.slices=64", "mission.planner.candidates.count=60", "mission.planner.refined=0",
          "mission.area.polygon.slice.half_thickness=0.1", "mission.limits.max_scans=3", "threads=1",
          "judge.reach_step=1", "model.picture_width=160"})
      entries.Set(section + assignment);
    return entries;
  }
};

TEST_F(ExploreStudyTest, LeavesStepsAndTheModelThatFiguresAreDrawnOf) {
  Run("explore", Quick());
  const std::vector<ExploredStep> steps = ReadSteps(folder_ / "run");
  ASSERT_EQ(steps.size(), 3U);
  EXPECT_TRUE(steps[0].view.has_value());
  EXPECT_TRUE(steps[0].driven_map.empty());
  EXPECT_GT(steps[1].driven_map.size(), 5U);
  EXPECT_TRUE(steps[2].planned_map.empty()) << "the last one";
  const Eigen::Vector2d off = steps[1].driven_map.back() - steps[1].T_map_base().translation;
  EXPECT_LT(off.norm(), 0.2);
  for (const char* file : {"building.dxf", "building.wrl", "mesh.glb", "map.bt", "grid.pgm", "leaves.ply",
                           "plan_1.50.svg", "README.txt", "steps/step002.svg", "figures/mesh.png"})
    EXPECT_FALSE(Content(std::string("run/") + file).empty()) << file;
  EXPECT_GT(ReadJson("run/model.json")["mesh_triangles"], 1000);

  OptionEntries entries;
  for (const std::string& assignment : {"run=" + (folder_ / "run").string(), std::string("width=160")})
    entries.Set(assignment);
  Run("fig_12", entries, "fig_12");
  const Json metrics = ReadJson("fig_12/metrics.json");
  EXPECT_EQ(metrics["stops"], 3);
  EXPECT_GT(metrics["way_m"], 0.5);
  EXPECT_THAT(Content("fig_12/figures/fig_12.png"), StartsWith("\x89PNG"));
  entries.Set("scans=2");
  Run("fig_13", entries, "fig_13");
  const Table scans = FromCsv(Content("fig_13/scans.csv"));
  ASSERT_EQ(scans.rows.size(), 2U);
  EXPECT_GT(std::stod(scans.rows[0][2]), 0.0) << "something is unseen";
  for (const char* file : {"fig_13/figures/fig_13_scans.png", "fig_13/figures/fig_13_boxes.png"})
    EXPECT_THAT(Content(file), StartsWith("\x89PNG")) << file;
}

TEST_F(ExploreStudyTest, AFigureWithoutARunExploresFirst) {
  OptionEntries entries = Quick("explore.");
  for (const char* assignment : {"explore.mission.limits.max_scans=1", "width=160"})
    entries.Set(assignment);
  Run("fig_12", entries);
  EXPECT_EQ(ReadJson("run/metrics.json")["stops"], 1);
  EXPECT_EQ(ReadJson("run/exploration/progress.json")["state"], "finished");
}

TEST_F(ExploreStudyTest, AFigureOfNoExplorationIsAnError) {
  OptionEntries entries;
  entries.Set("run=" + (folder_ / "nothing").string());
  EXPECT_THAT(ErrorOf([&] { FindStudy("fig_12").check_input(entries); }), HasSubstr("holds no steps"));
}

}  // namespace
}  // namespace ariadne::experiments
