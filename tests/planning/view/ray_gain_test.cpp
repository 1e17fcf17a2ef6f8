#include "planning/view/ray_gain.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "planning/view/uniform_candidates.h"
#include "slam/geometry/angles.h"
#include "tests/planning/view/simple_room.h"
#include "tests/support/error_of.h"

namespace ariadne::planning {
namespace {

using slam::RadFromDeg;

/// What a ray meets, by solving p + t u = a + s (b - a) for every edge.
struct PlainHit {
  double distance = std::numeric_limits<double>::infinity();
  bool seen = false;
  bool is_grazing = false;  // rounding decides: the ray passes an end, or two hits are as near
};

PlainHit CastPlainly(std::span<const Edge> edges, const Eigen::Vector2d& p, double angle) {
  const Eigen::Vector2d u(std::cos(angle), std::sin(angle));
  PlainHit hit;
  for (const Edge& edge : edges) {
    Eigen::Matrix2d system;
    system << u, edge.from - edge.to;
    if (std::abs(system.determinant()) < 1e-12) continue;
    const Eigen::Vector2d solution = system.inverse() * (edge.from - p);
    const double t = solution[0], s = solution[1];
    if (t < 0.0 || s < -1e-9 || s > 1.0 + 1e-9) continue;
    const bool at_end = std::abs(s) < 1e-9 || std::abs(s - 1.0) < 1e-9;
    const bool is_tie = std::abs(t - hit.distance) < 1e-9;
    if (t < hit.distance) hit.distance = t, hit.seen = edge.seen, hit.is_grazing = at_end;
    hit.is_grazing = hit.is_grazing || is_tie;
  }
  return hit;
}

std::vector<Eigen::Vector2d> PlacesInHall(int count, std::uint64_t seed) {
  CandidateOptions options;
  options.count = count;
  return DrawCandidates(std::array{Hall()}, {}, options, seed);
}

/// Edges anywhere, also crossing each other and around the place.
std::vector<Edge> DrawEdges(int count, double size, RandomStream& stream) {
  std::vector<Edge> edges;
  const auto draw = [&] {
    return Eigen::Vector2d(DrawUniform(stream, -size, size), DrawUniform(stream, -size, size));
  };
  for (int i = 0; i < count; ++i) edges.push_back({draw(), draw(), DrawUniform(stream, 0.0, 1.0) < 0.5});
  return edges;
}

/// Returns how many rays were compared.
int ExpectSameAsPlainly(std::span<const Edge> edges, const Eigen::Vector2d& p, double heading,
                        const RayGainOptions& options) {
  const RayGain gain(edges, heading, options);
  const std::vector<RayHit> hits = gain.Cast(p);
  int compared = 0;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const double angle = heading + 2.0 * std::numbers::pi * static_cast<double>(i) / options.rays;
    const PlainHit plain = CastPlainly(edges, p, angle);
    if (plain.is_grazing) continue;
    const bool in_range = plain.distance >= options.min_range && plain.distance <= options.max_range;
    EXPECT_EQ(gain.IsUnseen(hits[i]), in_range && !plain.seen) << "ray " << i << " from " << p.transpose();
    if (plain.distance <= options.max_range) {
      EXPECT_NEAR(hits[i].distance, plain.distance, 1e-6 * (1.0 + plain.distance));
    }
    ++compared;
  }
  return compared;
}

TEST(RayGain, MeetsWhatPlainRaysMeetInTheHall) {
  const std::vector<Edge> edges = LabelledHall(1);
  int compared = 0;
  for (const Eigen::Vector2d& p : PlacesInHall(100, 2)) compared += ExpectSameAsPlainly(edges, p, 0.3, {});
  EXPECT_GT(compared, 35900);
}

/// The largest number of unseen hits within half a turn, both end rays included, by plain rays.
int GainPlainly(std::span<const Edge> edges, const Eigen::Vector2d& p, double heading,
                const RayGainOptions& options) {
  std::vector<int> unseen;
  for (int i = 0; i < options.rays; ++i) {
    const PlainHit hit = CastPlainly(edges, p, heading + 2.0 * std::numbers::pi * i / options.rays);
    const bool in_range = hit.distance >= options.min_range && hit.distance <= options.max_range;
    unseen.push_back(in_range && !hit.seen ? 1 : 0);
  }
  int best = 0;
  for (int first = 0; first < options.rays; ++first) {
    int sum = 0;
    for (int k = 0; k <= options.rays / 2; ++k)
      sum += unseen[static_cast<std::size_t>((first + k) % options.rays)];
    best = std::max(best, sum);
  }
  return best;
}

TEST(RayGain, IsExactWithinOneOf181Rays) {
  int same = 0, all = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const std::vector<Edge> edges = LabelledHall(seed);
    const double heading = 0.1 * static_cast<double>(seed);
    const RayGain gain(edges, heading, {});
    for (const Eigen::Vector2d& p : PlacesInHall(50, seed)) {
      const int exact = GainPlainly(edges, p, heading, {}), found = gain.At(p).gain;
      EXPECT_NEAR(found, exact, 1) << p.transpose();
      EXPECT_GT(found, 0);
      same += found == exact ? 1 : 0, ++all;
    }
  }
  EXPECT_GE(same, 0.95 * all);
}

TEST(RayGain, MeetsWhatPlainRaysMeetAmongAnyEdges) {
  RandomStream stream = NamedStream(4, "ray_gain");
  int compared = 0, rays = 0;
  for (int i = 0; i < 300; ++i) {
    RayGainOptions options;
    options.rays = 4 + static_cast<int>(stream() % 1000);
    options.min_range = DrawUniform(stream, 0.0, 1.0);
    options.max_range = DrawUniform(stream, 2.0, 20.0);
    const double size = std::pow(10.0, DrawUniform(stream, -3.0, 1.5));
    compared += ExpectSameAsPlainly(DrawEdges(static_cast<int>(stream() % 30), size, stream), {0.0, 0.0},
                                    DrawUniform(stream, -9.0, 9.0), options);
    rays += options.rays;
  }
  EXPECT_GT(compared, 0.999 * rays);
}

TEST(RayGain, LetsNoRaySlipThroughACorner) {
  const std::vector<Edge> square = EdgesOf({Rectangle(-1.0, -1.0, 1.0, 1.0), {}}, false);
  const std::vector<Edge> diamond =
      EdgesOf({{{2.0, 0.0}, {0.0, 2.0}, {-2.0, 0.0}, {0.0, -2.0}}, {}}, false);
  const std::vector<Edge> clockwise =
      EdgesOf({{{2.0, 0.0}, {0.0, -2.0}, {-2.0, 0.0}, {0.0, 2.0}}, {}}, false);
  for (const auto& edges :
       {square, diamond, clockwise}) {  // rays at 0, 45, 90 deg ... pass exactly through corners
    for (const RayHit& hit : RayGain(edges, 0.0, {}).Cast({0.0, 0.0})) EXPECT_LT(hit.distance, 2.1);
  }
}

TEST(RayGain, SeenWinsWhereEdgesCoincide) {
  const Edge seen{{1.0, -1.0}, {1.0, 1.0}, true}, unseen{{1.0, -1.0}, {1.0, 1.0}, false};
  EXPECT_EQ(RayGain(std::array{seen, unseen}, 0.0, {}).At({0.0, 0.0}).gain, 0);
  EXPECT_EQ(RayGain(std::array{unseen, seen}, 0.0, {}).At({0.0, 0.0}).gain, 0);
  EXPECT_EQ(RayGain(std::array{unseen}, 0.0, {}).At({0.0, 0.0}).gain, 90)
      << "-45 to 45 deg, open at one end";
}

TEST(RayGain, CountsWithinTheRangeLimitsOnly) {
  const std::vector<Edge> wall{{{1.0, -50.0}, {1.0, 50.0}, false}};
  const RayGain gain(wall, 0.0, {});
  EXPECT_EQ(gain.At({0.6, 0.0}).gain, 2 * (88 - 36))
      << "from 0.5 m, acos(0.4 / 0.5) = 36.87 deg, to 15 m, acos(0.4 / 15) = 88.47 deg";
  EXPECT_EQ(gain.At({-13.9, 0.0}).gain, 2 * 6 + 1) << "acos(14.9 / 15) is 6.62 deg";
  EXPECT_EQ(gain.At({-14.1, 0.0}).gain, 0);
  const std::vector<RayHit> hits = gain.Cast({0.6, 0.0});
  EXPECT_FALSE(gain.IsUnseen(hits[0])) << "0.4 m is too near";
  EXPECT_TRUE(gain.IsUnseen(hits[60]));
}

TEST(RayGain, SeesNothingFromAnEdge) {
  const std::vector<Edge> edges{{{-1.0, 0.0}, {1.0, 0.0}, false}, {{-5.0, 3.0}, {5.0, 3.0}, false}};
  for (const double x : {-0.5, 0.0, 0.999}) {
    const std::vector<RayHit> hits = RayGain(edges, 0.1, {}).Cast({x, 0.0});
    for (const RayHit& hit : hits) EXPECT_EQ(hit.distance, 0.0);
  }
}

TEST(RayGain, SeesNothingFromACorner) {
  for (const slam::Ring& ring : {Rectangle(-1.0, -1.0, 1.0, 1.0), Rectangle(-1.0, -1.0, 1.0, 1.0, true)}) {
    const std::vector<Edge> room = EdgesOf({ring, {}}, false);
    for (const Eigen::Vector2d& corner : ring) {
      for (const RayHit& hit : RayGain(room, 0.1, {}).Cast(corner)) EXPECT_EQ(hit.distance, 0.0);
    }
  }
}

TEST(RayGain, CountsBothEndRaysOfTheView) {
  const std::vector<Edge> room = EdgesOf({Rectangle(-2.0, -2.0, 2.0, 2.0), {}}, false);
  EXPECT_EQ(RayGain(room, 0.0, {}).At({0.1, 0.2}).gain, 181);
  EXPECT_NEAR(RayGain(room, 0.7, {}).At({0.1, 0.2}).direction, 0.7, 1e-12) << "no reason to turn";
  RayGainOptions options;
  options.field_of_view = 360.0;
  EXPECT_EQ(RayGain(room, 0.0, options).At({0.1, 0.2}).gain, 360);
  options.field_of_view = 0.0;
  EXPECT_EQ(RayGain(room, 0.0, options).At({0.1, 0.2}).gain, 1);
}

TEST(RayGain, LooksAtTheMiddleOfADoor) {
  std::vector<Edge> room = EdgesOf({Rectangle(-4.0, -4.0, 4.0, 4.0), {}}, true);
  room.push_back({{-0.5, 3.0}, {0.5, 3.0}, false});
  for (const double heading : {0.0, 0.4, -2.0, 3.1}) {
    const ViewGain best = RayGain(room, heading, {}).At({0.0, 0.0});
    EXPECT_NEAR(best.gain, 2.0 * std::atan(0.5 / 3.0) / RadFromDeg(1.0), 1.0);
    EXPECT_NEAR(slam::WrapAngle(best.direction - RadFromDeg(90.0)), 0.0, RadFromDeg(0.51));
  }
}

TEST(RayGain, CountsAreaOnlyUntilARayIsBackInWhatIsKnown) {
  // A room of 4 x 4 m whose right side is unseen; 1 m behind it another known piece begins.
  std::vector<Edge> edges = EdgesOf({Rectangle(0.0, 0.0, 4.0, 4.0), {}}, true);
  edges[1].seen = false;
  RayGainOptions options;
  options.measure = GainMeasure::kArea;
  options.depth = 3.0;
  options.rays = 4;  // of which one meets the unseen side
  options.field_of_view = 0.0;
  options.until_known = true;
  const Eigen::Vector2d p(2.0, 2.0);
  const double step = 2.0 * std::numbers::pi / options.rays;
  EXPECT_NEAR(RayGain(edges, 0.0, options).At(p).area, 0.5 * step * (5.0 * 5.0 - 2.0 * 2.0), 1e-12);
  for (const Edge& edge : EdgesOf({Rectangle(5.0, -20.0, 9.0, 20.0), {}}, false)) edges.push_back(edge);
  for (int turn = 0; turn < 2; ++turn) {  // whichever edge comes first
    EXPECT_NEAR(RayGain(edges, 0.0, options).At(p).area, 0.5 * step * (3.0 * 3.0 - 2.0 * 2.0), 1e-12);
    std::ranges::reverse(edges);
  }
  options.until_known = false;
  EXPECT_NEAR(RayGain(edges, 0.0, options).At(p).area, 0.5 * step * (5.0 * 5.0 - 2.0 * 2.0), 1e-12);
}

/// What a direction shows, counted ray by ray.
struct PlainView {
  double gain = 0.0, overlap = 0.0;
};

PlainView LookPlainly(const RayGain& gain, std::span<const RayHit> hits, double max_range,
                      double direction) {
  PlainView view;
  const std::vector<std::size_t> rays = gain.RaysAbout(direction);
  for (const std::size_t i : rays) {
    if (gain.IsUnseen(hits[i])) view.gain += gain.GainOf(hits[i]);
    view.overlap += hits[i].seen && hits[i].distance <= max_range ? 1.0 : 0.0;
  }
  view.overlap /= static_cast<double>(rays.size());
  return view;
}

TEST(RayGain, LooksWhereItGainsMostAmongDirectionsWithOverlap) {
  int refused = 0, turned = 0;
  for (std::uint64_t trial = 1; trial <= 60; ++trial) {
    RayGainOptions options;
    options.measure = trial % 2 == 0 ? GainMeasure::kArea : GainMeasure::kRays;
    options.field_of_view = 60.0 * static_cast<double>(1 + trial % 4);
    options.rays = trial % 3 == 0 ? 72 : 240;
    const std::vector<Edge> edges = LabelledHall(trial, 4.0);
    const RayGain gain(edges, 0.2, options);
    const std::vector<RayHit> hits = gain.Cast(PlacesInHall(1, trial).front());
    const double step = 2.0 * std::numbers::pi / options.rays;
    // A window of an even number of rays has its middle between two.
    const double between = std::lround(options.field_of_view / 360.0 * options.rays) % 2 == 0 ? 0.0 : 0.5;
    for (const double least : {0.3, 0.5, 0.6, 0.7, 0.8}) {
      double best = -1.0;
      for (int i = 0; i < options.rays; ++i) {
        const PlainView plain = LookPlainly(gain, hits, options.max_range, 0.2 + (i + between) * step);
        if (plain.overlap >= least) best = std::max(best, plain.gain);
      }
      const ViewGain view = gain.Of(hits, least), free = gain.Of(hits);
      const PlainView own = LookPlainly(gain, hits, options.max_range, view.direction);
      EXPECT_EQ(view.overlap, own.overlap);
      EXPECT_EQ(view.overlap >= least, best >= 0.0) << "a place that has such a direction takes one";
      refused += best < 0.0 ? 1 : 0;
      if (best < 0.0) continue;
      // Ways to add up areas, and the ray less about a middle between two rays, make the difference.
      const double largest_ray = options.measure == GainMeasure::kArea ? 1.5 : 1.0;
      EXPECT_GE(own.gain, best - largest_ray - 1e-9) << trial << " " << least;
      if (view.direction == free.direction) continue;
      ++turned;
      EXPECT_NEAR(own.gain, best, 1e-2 * (1.0 + best)) << trial << " " << least;
      EXPECT_LE(own.gain, LookPlainly(gain, hits, options.max_range, free.direction).gain + largest_ray);
    }
  }
  EXPECT_GT(turned, 30);
  EXPECT_GT(refused, 10);
}

TEST(RayGain, DoesNotDependOnTheFrame) {
  const std::vector<Edge> edges = LabelledHall(5);
  RandomStream stream = NamedStream(6, "ray_gain/frame");
  int differing = 0;
  for (const Eigen::Vector2d& p : PlacesInHall(100, 8)) {
    const slam::Pose2 T_new_map{DrawUniform(stream, -3.0, 3.0),
                                {DrawUniform(stream, -100.0, 100.0), DrawUniform(stream, -100.0, 100.0)}};
    const double heading = DrawUniform(stream, -3.0, 3.0);
    const ViewGain here = RayGain(edges, heading, {}).At(p);
    const std::vector<Edge> moved = Moved(T_new_map, edges);
    const ViewGain there = RayGain(moved, heading + T_new_map.angle, {}).At(T_new_map * p);
    EXPECT_NEAR(here.gain, there.gain, 1);
    const double turned = slam::WrapAngle(there.direction - here.direction - T_new_map.angle);
    differing += here.gain != there.gain || std::abs(turned) > 1e-9;
  }
  EXPECT_EQ(differing, 0);
}

TEST(RayGain, RefusesWhatIsNoPlace) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Edge> bad{{{0.0, 0.0}, {nan, 1.0}, true}}, far{{{0.0, 0.0}, {1e300, 1.0}, true}};
  EXPECT_NE(ErrorOf([&] { RayGain(bad, 0.0, {}); }), "");
  EXPECT_NE(ErrorOf([&] { RayGain(far, 0.0, {}); }), "");
  EXPECT_EQ(ErrorOf([&] { RayGain({}, nan, {}); }), "the robot's heading is nan, which is no angle");
  EXPECT_EQ(ErrorOf([&] { RayGain({}, 0.0, {}).At({nan, 0.0}); }), "candidate 0 at (nan, 0) is no place");
  EXPECT_EQ(RayGain({}, 0.0, {}).At({0.0, 0.0}).gain, 0);
  RayGainOptions options;
  options.min_range = 20.0;
  EXPECT_NE(ErrorOf([&] { RayGain({}, 0.0, options); }).find("gain.min_range is 20 m"), std::string::npos);
}

}  // namespace
}  // namespace ariadne::planning
