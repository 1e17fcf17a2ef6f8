#include "experiments/bounds/shortest_tour.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "slam/base/random.h"
#include "tests/support/error_of.h"

namespace ariadne::experiments {
namespace {

/// Distances of places in a hall of 20 m x 20 m; with steps of a metre there are many equally short tours.
Eigen::MatrixXd RandomDistances(std::uint64_t seed, Eigen::Index count, double step = 0.0) {
  RandomStream stream = NamedStream(seed, "test/tour");
  Eigen::MatrixXd places(2, count);
  for (double& x : places.reshaped()) {
    x = DrawUniform(stream, 0.0, 20.0);
    if (step > 0.0) x = step * std::floor(x / step);
  }
  Eigen::MatrixXd distances(count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index j = 0; j < count; ++j) distances(i, j) = (places.col(i) - places.col(j)).norm();
  }
  return distances;
}

double Length(const Eigen::MatrixXd& distances, const std::vector<std::size_t>& order) {
  double length = 0.0;
  for (std::size_t k = 1; k < order.size(); ++k) {
    length += distances(static_cast<int>(order[k - 1]), static_cast<int>(order[k]));
  }
  return length;
}

double ShortestByTrial(const Eigen::MatrixXd& distances, std::size_t start) {
  std::vector<std::size_t> order(static_cast<std::size_t>(distances.rows()));
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::swap(order.front(), order[start]);
  std::sort(order.begin() + 1, order.end());
  double shortest = std::numeric_limits<double>::infinity();
  do {
    shortest = std::min(shortest, Length(distances, order));
  } while (std::next_permutation(order.begin() + 1, order.end()));
  return shortest;
}

void ExpectTour(const Eigen::MatrixXd& distances, std::size_t start, const ShortestTourResult& result) {
  ASSERT_EQ(result.order.size(), static_cast<std::size_t>(distances.rows()));
  EXPECT_EQ(result.order.front(), start);
  std::vector<std::size_t> places = result.order;
  std::sort(places.begin(), places.end());
  for (std::size_t i = 0; i < places.size(); ++i) EXPECT_EQ(places[i], i);
  EXPECT_NEAR(result.length, Length(distances, result.order), 1e-9);
  EXPECT_LE(result.lower_bound, result.length);
}

TEST(ShortestTour, IsTheShortestOfAllOrders) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    for (Eigen::Index count = 1; count <= 7; ++count) {
      const Eigen::MatrixXd distances = RandomDistances(seed, count, seed % 2 == 0 ? 0.0 : 4.0);
      const std::size_t start = seed % static_cast<std::size_t>(count);
      const ShortestTourResult result = ShortestTour(distances, start);
      ExpectTour(distances, start, result);
      EXPECT_NEAR(result.length, ShortestByTrial(distances, start), 1e-9) << seed << ", " << count;
      EXPECT_EQ(result.length, result.lower_bound);
    }
  }
}

TEST(ShortestTour, OfManyPlacesIsHardlyLonger) {
  ShortestTourOptions never_exact;
  never_exact.exact_places = 0;
  int shortest = 0;
  double bounds = 0.0;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const Eigen::MatrixXd distances = RandomDistances(seed, 11, seed % 2 == 0 ? 0.0 : 2.0);
    const ShortestTourResult improved = ShortestTour(distances, seed % 11, never_exact);
    const double best = ShortestTour(distances, seed % 11).length;
    ExpectTour(distances, seed % 11, improved);
    EXPECT_LE(improved.length, 1.05 * best);
    EXPECT_GE(improved.length, best - 1e-9);
    EXPECT_LE(improved.lower_bound, best + 1e-9);
    shortest += improved.length < best + 1e-9 ? 1 : 0;
    bounds += improved.lower_bound / best / 50.0;
  }
  EXPECT_GE(shortest, 45);
  EXPECT_GT(bounds, 0.95);
}

TEST(ShortestTour, GoesAlongACorridor) {
  // 40 places in a row, one metre apart; from the tenth, first to the near end.
  Eigen::MatrixXd distances(40, 40);
  for (int i = 0; i < 40; ++i) {
    for (int j = 0; j < 40; ++j) distances(i, j) = std::abs(i - j);
  }
  const ShortestTourResult result = ShortestTour(distances, 10);
  ExpectTour(distances, 10, result);
  EXPECT_DOUBLE_EQ(result.length, 10.0 + 39.0);
}

TEST(ShortestTour, RepeatsItself) {
  const Eigen::MatrixXd distances = RandomDistances(3, 40, 1.0);
  const ShortestTourResult first = ShortestTour(distances, 5);
  const ShortestTourResult second = ShortestTour(distances, 5);
  EXPECT_EQ(first.order, second.order);
  EXPECT_EQ(first.length, second.length);
  EXPECT_EQ(first.lower_bound, second.lower_bound);
}

TEST(ShortestTour, RefusesWhatAreNoDistances) {
  EXPECT_EQ(ErrorOf([] { ShortestTour(Eigen::MatrixXd::Zero(3, 2), 0); }),
            "distances of a tour are 3 x 2, not square");
  EXPECT_EQ(ErrorOf([] { ShortestTour(Eigen::MatrixXd::Zero(3, 3), 3); }),
            "a tour of 3 places cannot start at place 3");
  EXPECT_NE(ErrorOf([] { ShortestTour(Eigen::MatrixXd(), 0); }), "");
  Eigen::MatrixXd distances = RandomDistances(1, 4);
  distances(2, 1) = distances(1, 2) = std::numeric_limits<double>::infinity();
  EXPECT_EQ(ErrorOf([&] { ShortestTour(distances, 0); }), "places 1 and 2 of a tour are inf m apart");
  distances(2, 1) = distances(1, 2) = -1.0;
  EXPECT_NE(ErrorOf([&] { ShortestTour(distances, 0); }), "");
  distances(2, 1) = 3.0, distances(1, 2) = 4.0;
  EXPECT_EQ(ErrorOf([&] { ShortestTour(distances, 0); }),
            "places 1 and 2 of a tour are 4 m apart, but 3 m on the way back");
}

}  // namespace
}  // namespace ariadne::experiments
