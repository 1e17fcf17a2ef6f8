#include "planning/view/next_view.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>

#include "planning/view/uniform_candidates.h"
#include "slam/geometry/angles.h"
#include "tests/planning/view/simple_room.h"
#include "tests/support/error_of.h"

namespace ariadne::planning {
namespace {

using Places = std::vector<Eigen::Vector2d>;

Places DrawInHall(std::uint64_t seed) { return DrawCandidates(std::array{Hall()}, {}, {}, seed); }

const slam::Pose2 kRobot{0.5, {2.0, 2.0}};

/// Sec. 4.2 step 6 by its letters, in the paper's units; c1 in 1/cm, c2 in 1/deg; and what is not the
/// paper's.
void ExpectTheHighestValue(const NextViewOptions& options, double c1, double c2, double View::*gain) {
  const NextViewResult result = ChooseNextView(DrawInHall(1), LabelledHall(1), kRobot, options);
  ASSERT_EQ(result.status, NextViewStatus::kFound);
  ASSERT_EQ(result.views.size(), 200u);
  double highest = 0.0;
  for (const View& view : result.views) {
    double turn = std::fmod(std::abs(view.direction - kRobot.angle), 2.0 * M_PI) * 180.0 / M_PI;
    if (turn > 180.0) turn = 360.0 - turn;
    const double centimeters = 100.0 * std::hypot(view.p_map.x() - 2.0, view.p_map.y() - 2.0);
    const double rays = gain == nullptr ? view.gain : view.*gain;
    const double rest = std::pow(view.shown, options.rest_weight);
    EXPECT_NEAR(view.value, rays * rest * std::exp(-c1 * centimeters) * std::exp(-c2 * turn), 1e-9);
    if (view.gain >= options.min_gain) highest = std::max(highest, view.value);
  }
  EXPECT_EQ(result.views[*result.chosen].value, highest);
}

TEST(NextView, IsTheOneOfHighestValue) {
  ExpectTheHighestValue(PaperNextViewOptions(), 0.05, 0.01, nullptr);
  ExpectTheHighestValue({}, 0.001, 0.0, &View::area);
}

TEST(NextView, OfThePaperHardlyLeavesItsPlace) {
  const NextViewOptions paper = PaperNextViewOptions();
  EXPECT_DOUBLE_EQ(paper.distance_weight, 100.0 * 0.05);
  EXPECT_DOUBLE_EQ(paper.angle_weight, 0.01);
  // The second place has a gain of 71, the first of 4, and is 1.09 m nearer.
  const std::vector<Edge> edges{{{1.0, -0.001}, {1.0, 0.001}, false}, {{2.4, 9.0}, {2.4, 11.0}, false}};
  const Places places{{0.0, 0.0}, {1.0, 10.0}};
  const slam::Pose2 robot{0.0, {0.0, 4.5}};  // 4.5 m from the first, 5.6 m from the second
  EXPECT_EQ(ChooseNextView(places, edges, robot, paper).chosen, 0u);
  NextViewOptions calibrated;
  calibrated.min_gain = 1;
  EXPECT_EQ(ChooseNextView(places, edges, robot, calibrated).chosen, 1u);
}

TEST(NextView, LeavesNoRestBehindWhereItCan) {
  const std::vector<Edge> square = EdgesOf({Rectangle(-2.0, -2.0, 2.0, 2.0), {}}, false);
  const Places places{{0.0, 0.0},
                      {-1.9, 0.0}};  // half a turn shows half from the first, most from the second
  NextViewOptions options{.distance_weight = 0.0};
  options.gain.measure = GainMeasure::kRays;
  const NextViewResult result = ChooseNextView(places, square, {}, options);
  EXPECT_NEAR(result.views[0].shown, 0.5, 0.01);
  EXPECT_GT(result.views[1].shown, 0.85);
  EXPECT_EQ(result.chosen, 1u);
  options.rest_weight = 0.0;
  EXPECT_EQ(ChooseNextView(places, square, {}, options).chosen, 0u) << "of equal gains the first";
}

TEST(NextView, FirstWinsAmongEqualOnes) {
  const std::vector<Edge> edges{{{2.0, -1.0}, {2.0, 1.0}, false}};
  const Places places{{-9.0, 0.0}, {0.0, 0.0}, {0.0, 0.0}};
  EXPECT_EQ(ChooseNextView(places, edges, {}, {}).chosen, 1u);
}

TEST(NextView, ChoosesAlsoWhereValuesUnderflow) {
  const std::vector<Edge> edges{{{2.0, -1.0}, {2.0, 1.0}, false}};
  const Places places{{1.0, 0.0}, {0.0, 0.0}};
  const NextViewResult result = ChooseNextView(places, edges, {0.0, {-300.0, 0.0}}, PaperNextViewOptions());
  EXPECT_EQ(result.views[0].value, 0.0);
  EXPECT_EQ(result.chosen, 1u) << "5 m are worth e^5 rays times less than the gain";
}

TEST(NextView, EndsWhereNothingIsLeftToSee) {
  const NextViewResult explored =
      ChooseNextView(DrawInHall(1), EdgesOf(Hall(), true), kRobot, NextViewOptions());
  EXPECT_EQ(explored.status, NextViewStatus::kNoGain);
  EXPECT_FALSE(explored.chosen);
  EXPECT_EQ(explored.views.size(), 200u);
  EXPECT_EQ(ChooseNextView({}, LabelledHall(1), kRobot, {}).status, NextViewStatus::kNoCandidates);
  EXPECT_EQ(ChooseNextView(DrawInHall(1), {}, kRobot, {}).status, NextViewStatus::kNoGain);
}

TEST(NextView, LeavesOutViewsOfTooLittleGain) {
  const std::vector<Edge> edges{{{1.0, -0.001}, {1.0, 0.001}, false}, {{4.0, 29.0}, {4.0, 31.0}, false}};
  const Places places{{0.0, 0.0}, {1.0, 30.0}};  // of gain 1 and 36
  NextViewOptions options;
  EXPECT_EQ(ChooseNextView(places, edges, {}, options).chosen, 1u);
  options.min_gain = 1;
  options.distance_weight = 5.0;
  EXPECT_EQ(ChooseNextView(places, edges, {}, options).chosen, 0u);
  options.min_gain = 100;
  EXPECT_EQ(ChooseNextView(places, edges, {}, options).status, NextViewStatus::kNoGain);
}

TEST(NextView, IsTheSameInAnyFrame) {
  const std::vector<Edge> edges = LabelledHall(2);
  const Places places = DrawInHall(3);
  const NextViewResult here = ChooseNextView(places, edges, kRobot, {});
  const slam::Pose2 T_new_map{2.2, {-40.0, 17.0}};
  Places moved;
  for (const Eigen::Vector2d& p : places) moved.push_back(T_new_map * p);
  const NextViewResult there = ChooseNextView(moved, Moved(T_new_map, edges), T_new_map * kRobot, {});
  EXPECT_EQ(here.chosen, there.chosen);
  for (std::size_t i = 0; i < here.views.size(); ++i) {
    EXPECT_EQ(here.views[i].gain, there.views[i].gain);
    EXPECT_NEAR(here.views[i].value, there.views[i].value, 1e-9);
  }
}

std::vector<char> BytesOf(const NextViewResult& result) {
  std::vector<char> bytes;
  const auto append = [&](const auto& value) {
    const auto* begin = reinterpret_cast<const char*>(&value);
    bytes.insert(bytes.end(), begin, begin + sizeof value);
  };
  append(*result.chosen);
  for (const auto& [p_map, direction, gain, area, shown, overlap, distance, turn, value] : result.views) {
    append(p_map.x()), append(p_map.y()), append(direction), append(gain), append(area), append(shown);
    append(overlap), append(distance), append(turn), append(value);
  }
  return bytes;
}

TEST(NextView, RepeatsItselfToTheByte) {
  const std::vector<Edge> edges = LabelledHall(2);
  const std::vector<char> first = BytesOf(ChooseNextView(DrawInHall(4), edges, kRobot, {}));
  for (int i = 0; i < 99; ++i) {
    ASSERT_EQ(BytesOf(ChooseNextView(DrawInHall(4), edges, kRobot, {})), first);
  }
}

TEST(NextView, RefusesWhatIsNoPlace) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Places places{{0.0, 0.0}};
  EXPECT_NE(ErrorOf([&] { ChooseNextView(Places{{0.0, 0.0}, {nan, 0.0}}, {}, kRobot, {}); }), "");
  EXPECT_NE(ErrorOf([&] { ChooseNextView(places, {}, {nan, {0.0, 0.0}}, {}); }), "");
  EXPECT_EQ(ErrorOf([&] {
              ChooseNextView(places, {}, {0.0, {nan, 0.0}}, {});
            }),
            "robot 0 at (nan, 0) is no place");
  NextViewOptions options;
  options.distance_weight = -1.0;
  EXPECT_NE(ErrorOf([&] { ChooseNextView(places, {}, kRobot, options); }).find("view.distance_weight"),
            std::string::npos);
}

}  // namespace
}  // namespace ariadne::planning
