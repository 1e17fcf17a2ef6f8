#include "planning/view/uniform_candidates.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "tests/planning/view/simple_room.h"
#include "tests/support/error_of.h"

namespace ariadne::planning {
namespace {

using Places = std::vector<Eigen::Vector2d>;

constexpr int kColumns = 20, kRows = 12;  // cells of 1 m

/// The free area of each cell, by a lattice that meets no wall [m^2].
std::vector<double> AreaOfCells(const slam::Polygon2& polygon) {
  constexpr int kPerCell = 40;
  std::vector<double> area(static_cast<std::size_t>(kColumns * kRows), 0.0);
  for (int x = 0; x < kColumns * kPerCell; ++x) {
    for (int y = 0; y < kRows * kPerCell; ++y) {
      const Eigen::Vector2d p((x + 0.5) / kPerCell, (y + 0.5) / kPerCell);
      const auto cell = static_cast<std::size_t>(y / kPerCell * kColumns + x / kPerCell);
      if (slam::Contains(polygon, p)) area[cell] += 1.0 / (kPerCell * kPerCell);
    }
  }
  return area;
}

/// The chi-square statistic per degree of freedom, and its bound at 4.3 sigma.
std::pair<double, double> ChiSquare(const Places& places, const std::vector<double>& area, double whole) {
  std::vector<int> found(area.size(), 0);
  for (const Eigen::Vector2d& p : places) {
    ++found[static_cast<std::size_t>(static_cast<int>(p.y()) * kColumns + static_cast<int>(p.x()))];
  }
  double chi2 = 0.0;
  int cells = 0;
  for (std::size_t i = 0; i < area.size(); ++i) {
    if (area[i] == 0.0) {
      EXPECT_EQ(found[i], 0) << "cell " << i << " lies in a hole";
      continue;
    }
    const double expected = static_cast<double>(places.size()) * area[i] / whole;
    chi2 += (found[i] - expected) * (found[i] - expected) / expected;
    ++cells;
  }
  const double freedom = cells - 1;
  return {chi2 / freedom, 1.0 + 4.3 * std::sqrt(2.0 / freedom)};
}

TEST(Candidates, AreUniformBesideHoles) {
  const std::array area{Hall()};
  CandidateOptions options;
  options.count = 40000;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const Places places = DrawCandidates(area, {}, options, seed);
    ASSERT_EQ(places.size(), 40000u);
    const auto [chi2, bound] = ChiSquare(places, AreaOfCells(area[0]), slam::Area(area[0]));
    EXPECT_LT(chi2, bound) << seed;
    EXPECT_GT(chi2, 2.0 - bound) << "too even to be random";
  }
}

TEST(Candidates, ChiSquareTellsWhatIsNotUniform) {
  const std::array area{Hall()};
  CandidateOptions options;
  options.count = 40000;
  Places places = DrawCandidates(area, {}, options, 1);
  for (Eigen::Vector2d& p : places) p.x() = p.x() < 19.0 ? p.x() : 19.0 + 0.9 * (p.x() - 19.0) - 0.2;
  std::erase_if(places, [&](const Eigen::Vector2d& p) { return !slam::Contains(area[0], p); });
  const auto [chi2, bound] = ChiSquare(places, AreaOfCells(area[0]), slam::Area(area[0]));
  EXPECT_GT(chi2, bound);
}

TEST(Candidates, ShareSeveralPartsByTheirArea) {
  const std::array<slam::Polygon2, 2> area{slam::Polygon2{Rectangle(0.0, 0.0, 1.0, 1.0), {}},
                                           slam::Polygon2{Rectangle(5.0, 5.0, 8.0, 6.0), {}}};
  CandidateOptions options;
  options.count = 10000;
  int large = 0;
  for (const Eigen::Vector2d& p : DrawCandidates(area, {}, options, 7)) large += p.x() > 3.0;
  EXPECT_NEAR(large, 7500, 4.0 * std::sqrt(10000 * 0.75 * 0.25));
}

TEST(Candidates, KeepClearOfEdgesByTheirLabel) {
  const std::array area{Hall()};
  const std::vector<Edge> edges = LabelledHall(3);
  CandidateOptions options;
  options.wall_clearance = 0.6;
  options.unseen_clearance = 0.2;
  const Places places = DrawCandidates(area, edges, options, 1);
  ASSERT_EQ(places.size(), 200u);
  for (const Eigen::Vector2d& p : places) {
    for (const Edge& edge : edges) EXPECT_GE(Distance(edge, p), edge.seen ? 0.6 : 0.2);
  }
}

TEST(Candidates, AreFewerWhereThereIsNoRoom) {
  CandidateOptions options;
  EXPECT_TRUE(DrawCandidates({}, {}, options, 1).empty());
  const std::array line{slam::Polygon2{{{0.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}}, {}}};
  EXPECT_TRUE(DrawCandidates(line, {}, options, 1).empty());
  const std::array room{slam::Polygon2{Rectangle(0.0, 0.0, 2.0, 2.0), {}}};
  options.wall_clearance = 1.1;
  EXPECT_TRUE(DrawCandidates(room, EdgesOf(room[0], true), options, 1).empty());
}

TEST(Candidates, LieWithinAlsoWhatTheGridRounds) {
  const std::array area{slam::Polygon2{Rectangle(4e-5, 4e-5, 1.04e-3, 1.04e-3), {}}};
  const Places places = DrawCandidates(area, {}, {}, 1);
  EXPECT_EQ(places.size(), 200u);
  for (const Eigen::Vector2d& p : places) EXPECT_TRUE(slam::Contains(area[0], p)) << p.transpose();
}

TEST(Candidates, ThatAreWantedAreTheFirstOfAll) {
  const std::array area{Hall()};
  const std::vector<Edge> edges = LabelledHall(3);
  CandidateOptions options;
  options.count = 300;
  options.wall_clearance = 0.3;
  const auto is_wanted = [&](const Eigen::Vector2d& p) {
    return p.x() < 4.0 && slam::Contains(area[0], p);
  };
  Places wanted = DrawCandidates(area, edges, options, 1);
  std::erase_if(wanted, [&](const Eigen::Vector2d& p) { return !is_wanted(p); });
  ASSERT_GT(wanted.size(), 40u);
  EXPECT_EQ(DrawWantedCandidates(area, edges, options, 1, 300, is_wanted), wanted) << "all that there are";
  wanted.resize(20);
  EXPECT_EQ(DrawWantedCandidates(area, edges, options, 1, 20, is_wanted), wanted);
}

TEST(Candidates, FollowTheSeed) {
  const std::array area{Hall()};
  EXPECT_EQ(DrawCandidates(area, {}, {}, 5), DrawCandidates(area, {}, {}, 5));
  EXPECT_NE(DrawCandidates(area, {}, {}, 5), DrawCandidates(area, {}, {}, 6));
}

TEST(Candidates, RefuseWhatIsNoPlace) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::array area{Hall()};
  EXPECT_EQ(ErrorOf([&] {
              DrawCandidates(area, std::array{Edge{{0.0, nan}, {1.0, 2.0}, true}}, {}, 1);
            }),
            "edge 0 from (0, nan) to (1, 2) has an end that is no place");
  const std::array bad{slam::Polygon2{{{0.0, 0.0}, {1.0, nan}, {0.0, 1.0}}, {}}};
  EXPECT_NE(ErrorOf([&] { DrawCandidates(bad, {}, {}, 1); }), "");
  CandidateOptions options;
  options.count = 0;
  EXPECT_NE(ErrorOf([&] { DrawCandidates(area, {}, options, 1); }).find("candidates.count"),
            std::string::npos);
}

}  // namespace
}  // namespace ariadne::planning
