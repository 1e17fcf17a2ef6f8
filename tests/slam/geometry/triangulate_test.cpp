#include "slam/geometry/triangulate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "slam/base/random.h"
#include "tests/support/error_of.h"

namespace ariadne::slam {
namespace {

double AreaOf(const Triangles2& mesh) {
  double area = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const double piece = SignedArea({mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]});
    EXPECT_GT(piece, 0.0) << "counterclockwise";
    area += piece;
  }
  return area;
}

Ring Square(double low, double high, bool clockwise = false) {
  Ring ring{{low, low}, {high, low}, {high, high}, {low, high}};
  if (clockwise) std::reverse(ring.begin(), ring.end());
  return ring;
}

/// A star around a place, with corners at random distances.
Ring DrawStar(RandomStream& stream, const Eigen::Vector2d& center, double radius) {
  Ring ring;
  for (int i = 0; i < 40; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 40.0;
    ring.push_back(center + DrawUniform(stream, 0.4, 1.0) * radius *
                                Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  return ring;
}

TEST(Triangulated, LeavesHolesOpen) {
  const Polygon2 frame{Square(0.0, 4.0), {Square(1.0, 2.0, true), Square(2.5, 3.0, true)}};
  const Triangles2 mesh = Triangulated(std::array{frame});
  EXPECT_NEAR(AreaOf(mesh), 16.0 - 1.0 - 0.25, 1e-3);
  for (const auto& [a, b, c] : mesh.triangles) {
    const Eigen::Vector2d middle = (mesh.vertices[a] + mesh.vertices[b] + mesh.vertices[c]) / 3.0;
    EXPECT_TRUE(Contains(frame, middle)) << middle.transpose();
  }
}

TEST(Triangulated, CoversPolygonsOfAnyForm) {
  RandomStream stream = NamedStream(1, "triangulate");
  for (int i = 0; i < 50; ++i) {
    const Polygon2 a{DrawStar(stream, {0.0, 0.0}, 3.0), {}}, b{DrawStar(stream, {8.0, 1.0}, 2.0), {}};
    const double area = SignedArea(a.outer) + SignedArea(b.outer);
    EXPECT_NEAR(AreaOf(Triangulated(std::array{a, b})), area, 5e-3) << i;
  }
}

// Rounded to 0.1 mm, the small holes cross themselves and each other.
TEST(Triangulated, TakesSliversThatCross) {
  const Polygon2 wedge{
      {{-0.9384, -0.0622}, {-0.931, -0.0697}, {0.3431, -0.4276}},
      {{{-0.9263, -0.0661}, {-0.9265, -0.0661}, {-0.9264, -0.066}, {-0.9262, -0.0661}, {-0.9266, -0.0662}},
       {{-0.926, -0.0666}, {-0.9264, -0.0667}, {-0.9265, -0.0666}}}};
  EXPECT_NEAR(AreaOf(Triangulated(std::array{wedge})), SignedArea(wedge.outer), 1e-6);
}

TEST(Triangulated, IsRightBesideManySlivers) {
  RandomStream stream = NamedStream(2, "triangulate");
  for (int i = 0; i < 200; ++i) {
    Polygon2 room{Square(0.0, 1.0), {}};
    for (int k = 0; k < 40; ++k) {
      const double x = DrawUniform(stream, 0.1, 0.9), y = DrawUniform(stream, 0.1, 0.9);
      Ring sliver = DrawStar(stream, {x, y}, 4e-4);
      sliver.resize(3 + static_cast<std::size_t>(k) % 20);
      std::ranges::reverse(sliver);
      room.holes.push_back(sliver);
    }
    EXPECT_NEAR(AreaOf(Triangulated(std::array{room})), 1.0, 1e-4) << i;
  }
}

TEST(Triangulated, CountsWhatOverlapsOnce) {
  const Polygon2 a{Square(0.0, 2.0), {}}, b{Square(1.0, 3.0), {}};
  EXPECT_NEAR(AreaOf(Triangulated(std::array{a, b})), 4.0 + 4.0 - 1.0, 1e-6);
}

TEST(Triangulated, OfNothingIsNothing) {
  EXPECT_TRUE(Triangulated({}).triangles.empty());
  const Polygon2 line{{{0.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}}, {}};
  EXPECT_TRUE(Triangulated(std::array{line}).triangles.empty());
}

TEST(Triangulated, RefusesCornersThatAreNoPlaces) {
  const Polygon2 bad{{{0.0, 0.0}, {1.0, std::numeric_limits<double>::quiet_NaN()}, {0.0, 1.0}}, {}};
  EXPECT_EQ(ErrorOf([&] { Triangulated(std::array{bad}); }), "(1, nan) is no corner of a polygon");
}

}  // namespace
}  // namespace ariadne::slam
