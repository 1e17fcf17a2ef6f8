#include "planning/path/plane_neighbors.h"

#include <gtest/gtest.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>

#include <memory>
#include <numbers>

namespace ariadne::planning::internal {
namespace {

struct Motion {
  ompl::base::State* state;
};

TEST(PlaneNeighbors, FindWhatOmplFindsWithFewerDistances) {
  auto space = std::make_shared<ompl::base::ReedsSheppStateSpace>(0.3);
  ompl::base::RealVectorBounds bounds(2);
  bounds.setLow(0.0), bounds.setHigh(10.0);
  space->setBounds(bounds);
  std::size_t distances = 0;
  const auto distance = [&](Motion* a, Motion* b) {
    ++distances;
    return space->distance(a->state, b->state);
  };
  PlaneNeighbors<Motion*> neighbors;
  ompl::NearestNeighborsLinear<Motion*> linear;
  neighbors.setDistanceFunction(distance);
  linear.setDistanceFunction(distance);
  EXPECT_THROW(neighbors.nearest(nullptr), ompl::Exception) << "none there";
  RandomStream stream = NamedStream(7, "poses");
  std::vector<Motion> motions(300);
  std::vector<ompl::base::ScopedState<>> states(motions.size(), ompl::base::ScopedState<>(space));
  const auto draw = [&](ompl::base::State* state) {
    const double x = DrawUniform(stream, 0.0, 10.0), y = DrawUniform(stream, 0.0, 10.0);
    SetState({DrawUniform(stream, -std::numbers::pi, std::numbers::pi), {x, y}}, state);
  };
  for (std::size_t i = 0; i < motions.size(); ++i) {
    draw(states[i].get());
    if (i % 10 == 9) space->copyState(states[i].get(), states[i - 1].get());  // as near as the one before
    motions[i].state = states[i].get();
    neighbors.add(&motions[i]);
    linear.add(&motions[i]);
  }
  ompl::base::ScopedState<> of(space);
  Motion query{of.get()};
  std::size_t ours = 0, all = 0;
  for (int i = 0; i < 200; ++i) {
    draw(of.get());
    distances = 0;
    const Motion* nearest = neighbors.nearest(&query);
    ours += distances, distances = 0;
    EXPECT_EQ(nearest, linear.nearest(&query)) << i;
    all += distances;
  }
  EXPECT_LT(5 * ours, all);
}

}  // namespace
}  // namespace ariadne::planning::internal
