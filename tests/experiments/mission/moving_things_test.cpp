#include "experiments/mission/moving_things.h"

#include <gtest/gtest.h>

#include "slam/base/random.h"

namespace ariadne::experiments {
namespace {

using Eigen::Vector2d;

constexpr double kPeriod = 0.05;  // [s]

/// A wall along y = 4, and before it a leg of 12 cm at a place, both with the scanner's noise.
std::vector<Vector2d> WallAndLeg(const Vector2d& leg, RandomStream& stream) {
  const auto noisy = [&stream](double x, double y) {
    const double dx = DrawNormal(stream, 0.0, 0.01);
    const double dy = DrawNormal(stream, 0.0, 0.01);
    return Vector2d(x + dx, y + dy);
  };
  std::vector<Vector2d> points;
  for (double x = -3.0; x < leg.x() - 0.1; x += 0.07) points.push_back(noisy(x, 4.0));
  for (double x = -0.06; x <= 0.06; x += 0.03) points.push_back(noisy(leg.x() + x, leg.y()));
  for (double x = leg.x() + 0.1; x < 3.0; x += 0.07) points.push_back(noisy(x, 4.0));
  return points;
}

std::vector<Vector2d> WatchedPlaces(const Vector2d& from, const Vector2d& velocity, double time,
                                    double later) {
  RandomStream stream = NamedStream(1, "leg");
  MovingThings things;
  for (double t = 0.0; t <= time + 1e-9; t += kPeriod)
    things.Update(WallAndLeg(from + t * velocity, stream), {0.0, 0.0}, t);
  return things.PlacesUntil(later);
}

TEST(MovingThings, AreWhereTheyGoOnTo) {
  const Vector2d from(-1.0, 2.0), velocity(1.2, -0.4);
  const std::vector<Vector2d> places = WatchedPlaces(from, velocity, 0.6, 1.5);
  ASSERT_FALSE(places.empty());
  const Vector2d end = from + 2.1 * velocity;
  double nearest = 100.0;
  for (const Vector2d& place : places) {
    nearest = std::min(nearest, (place - end).norm());
    const double along = std::clamp((place - from).dot(velocity.normalized()), 0.0, 3.0);
    EXPECT_LT((place - from - along * velocity.normalized()).norm(), 0.6) << "only along its way";
  }
  EXPECT_LT(nearest, 0.45);
}

TEST(MovingThings, AreNoneWhereAllStands) {
  EXPECT_TRUE(WatchedPlaces({0.0, 2.0}, {0.0, 0.0}, 1.0, 2.0).empty());
}

TEST(MovingThings, AreKeptOffByABodysWidthWhenTheyStop) {
  RandomStream stream = NamedStream(3, "leg");
  MovingThings things;
  for (double t = 0.0; t < 3.0; t += kPeriod)
    things.Update(WallAndLeg({std::min(t, 1.0), 2.0}, stream), {0.0, 0.0}, t);
  const std::vector<Vector2d> places = things.PlacesUntil(2.0);
  EXPECT_EQ(places.size(), 8U);
  for (const Vector2d& place : places) EXPECT_NEAR((place - Vector2d(1.0, 2.0)).norm(), 0.4, 0.03);
}

/// One leg hides the other for a while, and when both stand, the one that walked is hidden.
TEST(MovingThings, WalkOnWhereNoScannerLooks) {
  RandomStream stream = NamedStream(5, "leg");
  MovingThings things;
  const Vector2d from(-1.0, 2.0), velocity(1.2, 0.0);
  double time = 0.0;
  for (; time < 1.0; time += kPeriod)
    things.Update(WallAndLeg(from + time * velocity, stream), {0.0, 0.0}, time);
  const auto pass_unseen = [&](double until) {
    for (; time < until; time += kPeriod) things.Update({}, {0.0, 0.0}, time);
    double nearest = 100.0;
    for (const Vector2d& place : things.PlacesUntil(0.0))
      nearest = std::min(nearest, (place - from - time * velocity).norm());
    return nearest;
  };
  EXPECT_LT(pass_unseen(1.5), 0.5);
  EXPECT_EQ(pass_unseen(2.0), 100.0) << "nobody knows where by now";
}

TEST(MovingThings, AreBothLegsOfWhoHasWalked) {
  RandomStream stream = NamedStream(7, "legs");
  MovingThings things;
  for (double t = 0.0; t < 3.0; t += kPeriod) {
    const double x = std::min(t, 1.0) + (t > 2.0 ? 0.3 : 0.0);
    things.Update(WallAndLeg({x, 2.0}, stream), {0.0, 0.0}, t);
  }
  EXPECT_EQ(things.PlacesUntil(2.0).size(), 8U);
  things.Update(WallAndLeg({2.2, 2.0}, stream), {0.0, 0.0}, 3.0);
  EXPECT_TRUE(things.PlacesUntil(2.0).empty()) << "too far away to be of the same person";
}

TEST(MovingThings, AreNotWhatIsSeenOfAWallPastAPillar) {
  RandomStream stream = NamedStream(4, "wall");
  MovingThings things;
  for (double t = 0.0; t < 2.0; t += kPeriod) {  // between two pillars; the robot passes
    std::vector<Vector2d> points{{-0.5, 1.0}, {-0.4, 1.0}};
    for (double x = -0.3 + 0.5 * t; x < 0.3 + 0.5 * t; x += 0.07) {
      const double noise = DrawNormal(stream, 0.0, 0.01);
      points.emplace_back(x, 3.0 + noise);
    }
    points.emplace_back(0.4, 1.0), points.emplace_back(0.5, 1.0);
    things.Update(points, {0.1 - 0.2 * t, 0.0}, t);
  }
  EXPECT_TRUE(things.PlacesUntil(2.0).empty());
}

TEST(MovingThings, AreNotWhatJumpsToAndFro) {
  RandomStream stream = NamedStream(5, "leaves");
  MovingThings things;
  for (double t = 0.0; t < 10.0; t += kPeriod) {
    const double x = DrawUniform(stream, -0.1, 0.1);
    const double y = DrawUniform(stream, -0.1, 0.1);
    things.Update(WallAndLeg({x, 2.0 + y}, stream), {0.0, 0.0}, t);
    ASSERT_TRUE(things.PlacesUntil(2.0).empty()) << t;
  }
}

TEST(MovingThings, AreNotWhereSomethingIsKnownToStand) {
  RandomStream stream = NamedStream(6, "leg");
  MovingThings things;
  for (double t = 0.0; t < 0.6; t += kPeriod) things.Update(WallAndLeg({t, 2.0}, stream), {0.0, 0.0}, t);
  EXPECT_FALSE(things.PlacesUntil(1.0).empty());
  EXPECT_FALSE(things.PlacesUntil(1.0, [](const Vector2d&) { return false; }).empty());
  EXPECT_TRUE(things.PlacesUntil(1.0, [](const Vector2d& p) { return p.y() > 1.5; }).empty());
}

TEST(MovingThings, AreNotBelievedAtOnce) {
  EXPECT_TRUE(WatchedPlaces({0.0, 2.0}, {1.0, 0.0}, 0.1, 2.0).empty());
}

TEST(MovingThings, AreTheSameInAnotherFrame) {
  RandomStream stream = NamedStream(2, "leg");
  MovingThings here, there;
  const Vector2d moved(5.0, -3.0);
  for (double t = 0.0; t < 0.6; t += kPeriod) {
    std::vector<Vector2d> points = WallAndLeg(Vector2d(t, 2.0), stream);
    here.Update(points, {0.0, 0.0}, t);
    for (Vector2d& p : points) p += moved;
    there.Update(points, moved, t);
  }
  const std::vector<Vector2d> a = here.PlacesUntil(1.0), b = there.PlacesUntil(1.0);
  ASSERT_EQ(a.size(), b.size());
  ASSERT_FALSE(a.empty());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_LT((a[i] + moved - b[i]).norm(), 1e-9);
}

}  // namespace
}  // namespace ariadne::experiments
