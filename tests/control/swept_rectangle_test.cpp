#include "control/swept_rectangle.h"

#include <gtest/gtest.h>

#include <limits>

#include "control/resample_path.h"
#include "control/simulate_approach.h"
#include "tests/control/sweep_oracle.h"
#include "tests/support/error_of.h"

namespace ariadne::control {
namespace {

using Eigen::Vector2d;
using slam::Pose2;
using slam::Ring;

RectangleOptions Bare() {
  RectangleOptions robot;
  robot.margin = 0.0;
  return robot;
}

/// Between two areas that do not meet [m].
double Distance(const Ring& a, const Ring& b) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& [p, q] : {std::pair{&a, &b}, std::pair{&b, &a}}) {
    for (const Vector2d& corner : *p) {
      for (std::size_t k = 0; k < q->size(); ++k) {
        const Vector2d from = (*q)[k], edge = (*q)[(k + 1) % q->size()] - from;
        const double along = std::clamp((corner - from).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
        nearest = std::min(nearest, (corner - from - along * edge).norm());
      }
    }
  }
  return nearest;
}

TEST(SweptRectangle, KnowsWhetherItMeetsAnOutline) {
  RandomStream stream = NamedStream(1, "test/sweep");
  RectangleOptions robot;
  robot.centre_ahead = 0.13;
  int meets = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const Pose2 pose{DrawUniform(stream, -4, 4), {DrawUniform(stream, -1, 1), DrawUniform(stream, -1, 1)}};
    const Ring outline = DrawOutline(stream);
    const Ring rectangle = RectangleRing(robot, pose);
    const double gap = GapTo(robot, pose, outline);
    const bool meet = AreasMeet(rectangle, outline);
    meets += meet ? 1 : 0;
    ASSERT_EQ(gap <= 0.0, meet);
    if (meet) continue;
    const double distance = Distance(rectangle, outline);
    ASSERT_LE(gap, distance + 1e-9);
    ASSERT_GE(gap, 0.7 * distance);
    ASSERT_NEAR(GapTo(robot, pose, outline[0]), GapTo(robot, pose, Ring{outline[0]}), 1e-12);
  }
  EXPECT_GT(meets, 100);
}

TEST(SweptRectangle, OverlooksNothingAndRarelyAlarms) {
  RandomStream stream = NamedStream(2, "test/sweep");
  const RectangleOptions robot;
  int free = 0, alarms = 0, hits = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const std::vector<Pose2> poses = DrawArcs(stream);
    const GroundObstacles obstacles{{DrawOutline(stream), DrawOutline(stream)}, {}};
    const bool hit = FirstHit(robot, poses, obstacles).has_value();
    const bool hits_densely = DenselyHits(robot, poses, obstacles.outlines, 0.01);
    ASSERT_TRUE(hit || !hits_densely) << "overlooked in trial " << trial;
    hits += hits_densely ? 1 : 0;
    free += hits_densely ? 0 : 1;
    alarms += hit && !hits_densely ? 1 : 0;
  }
  EXPECT_GT(hits, 60);
  EXPECT_GT(free, 80);
  EXPECT_LE(alarms, 0.05 * free);
}

TEST(SweptRectangle, OfTheControllerTouchesWhereItSays) {
  const std::vector<Pose2> poses = ResamplePath(SimulateApproach({2.0, {-3.0, 1.0}}, {}, {}).samples, {});
  const Ring box = BoxOutline({0.3, {-1.5, 0.9}}, 0.5, 0.4);
  const auto hit = FirstHit({}, poses, {{BoxOutline({0.0, {5.0, 0.0}}, 1.0, 1.0), box}, {{-1.4, 0.8}}});
  ASSERT_TRUE(hit.has_value());
  EXPECT_EQ(hit->obstacle, 1U);
  EXPECT_NEAR(GapTo({}, hit->T_map_robot, box), 0.0, 0.003);
  const std::vector<Pose2> before(poses.begin(), poses.begin() + static_cast<int>(hit->interval) + 1);
  EXPECT_FALSE(DenselyHits({}, before, {box}, 0.01));
}

TEST(SweptRectangle, SweepsItsCornersInATurn) {
  std::vector<Pose2> turn;
  for (int i = 0; i <= 4; ++i) turn.push_back({0.4 * i, {0.0, 0.0}});
  // The corner is 0.5 m from the centre, the sides are 0.3 m.
  EXPECT_TRUE(FirstHit(Bare(), turn, {{}, {{0.0, 0.49}}}).has_value());
  EXPECT_FALSE(FirstHit(Bare(), turn, {{}, {{0.0, 0.502}}}).has_value());
  EXPECT_FALSE(FirstHit(Bare(), {turn[0]}, {{}, {{0.0, 0.49}}}).has_value());
}

TEST(SweptRectangle, FindsAThinThingBetweenTwoPoses) {
  const std::vector<Pose2> way{{0.0, {0.0, 0.0}}, {0.0, {3.0, 0.0}}};
  const auto hit = FirstHit(Bare(), way, {{{{1.5, 0.299}, {1.5, 2.0}}}, {}});
  ASSERT_TRUE(hit.has_value());
  EXPECT_NEAR(hit->share, (1.5 - 0.4) / 3.0, 0.001);
  EXPECT_FALSE(FirstHit(Bare(), way, {{{{1.5, 0.302}, {1.5, 2.0}}}, {}}).has_value());
}

TEST(SweptRectangle, TouchesOfManyPointsTheFirst) {
  RandomStream stream = NamedStream(4, "test/sweep");
  int touches = 0;
  for (int trial = 0; trial < 100; ++trial) {
    const std::vector<Pose2> poses = DrawArcs(stream);
    std::vector<Vector2d> points;
    for (int i = 0; i < 5; ++i) points.emplace_back(DrawUniform(stream, -1, 1), DrawUniform(stream, -1, 1));
    std::vector<Ring> rings;  // the same as outlines of one corner, which are looked at one by one
    for (const Vector2d& p : points) rings.push_back({p});
    const auto hit = FirstHit({}, {poses[0], poses[1]}, {rings, {}});
    const auto touch = FirstTouch({}, poses[0], poses[1], points);
    ASSERT_EQ(hit.has_value(), touch.has_value());
    if (!hit) continue;
    ++touches;
    EXPECT_NEAR(touch->share, hit->share, 0.02);
    EXPECT_TRUE(FirstHit({}, {poses[0], poses[1]}, {{}, {points[touch->point]}}).has_value());
  }
  EXPECT_GT(touches, 10);
}

TEST(SweptRectangle, IsTheSameInAnyFrame) {
  RandomStream stream = NamedStream(3, "test/sweep");
  const Pose2 T_new_map{2.2, {-40.0, 17.0}};
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<Pose2> poses = DrawArcs(stream);
    GroundObstacles obstacles{{DrawOutline(stream)}, {{1.0, 0.3}}};
    const auto here = FirstHit({}, poses, obstacles);
    for (Pose2& pose : poses) pose = T_new_map * pose;
    for (Vector2d& p : obstacles.outlines[0]) p = T_new_map * p;
    for (Vector2d& p : obstacles.points) p = T_new_map * p;
    const auto there = FirstHit({}, poses, obstacles);
    ASSERT_EQ(here.has_value(), there.has_value());
    if (!here) continue;
    const Pose2 expected = T_new_map * here->T_map_robot;
    EXPECT_LT((expected.translation - there->T_map_robot.translation).norm(), 0.01);
  }
}

TEST(SweptRectangle, MakesOutlinesConvex) {
  const Ring square = ConvexOutline({{0, 0}, {1, 1}, {0.5, 0.5}, {1, 0}, {0.5, 0}, {0, 1}, {0, 0}});
  EXPECT_EQ(square.size(), 4U);
  EXPECT_NEAR(slam::SignedArea(square), 1.0, 1e-12);
  EXPECT_EQ(ConvexOutline({{0, 0}, {1, 0}, {2, 0}}).size(), 2U);
  EXPECT_NEAR(slam::SignedArea(BoxOutline({0.7, {3, 4}}, 2.0, 0.5)), 1.0, 1e-12);
}

TEST(SweptRectangle, RefusesWhatIsNoObstacle) {
  const Ring dent{{0, 0}, {1, 0}, {0.2, 0.2}, {0, 1}};
  const Ring star{{0, 1}, {0.59, -0.81}, {-0.95, 0.31}, {0.95, 0.31}, {-0.59, -0.81}};
  EXPECT_NE(ErrorOf([&] { FirstHit({}, {{}}, {{dent}, {}}); }).find("not convex"), std::string::npos);
  EXPECT_NE(ErrorOf([&] { FirstHit({}, {{}}, {{star}, {}}); }).find("not convex"), std::string::npos);
  EXPECT_NE(ErrorOf([&] { FirstHit({}, {{}}, {{{}}, {}}); }).find("no corner"), std::string::npos);
  EXPECT_NE(ErrorOf([&] {
              FirstHit({}, {{std::nan(""), {0, 0}}}, {});
            }).find("not finite"),
            std::string::npos);
  EXPECT_FALSE(FirstHit({}, {}, {{BoxOutline({}, 1.0, 1.0)}, {}}).has_value());
}

}  // namespace
}  // namespace ariadne::control
