#pragma once

// Includes OMPL: for .cpp files only.

#include <ompl/datastructures/NearestNeighborsLinear.h>

#include <algorithm>
#include <vector>

#include "planning/path/ompl_support.h"

namespace ariadne::planning::internal {

/// The nearest motion of a tree among poses, as OMPL's linear search finds it and no other. No distance is
/// less than that of the places: of most poses the distance, the length of a Reeds-Shepp path, need not be
/// computed.
template <typename Motion>
class PlaneNeighbors : public ompl::NearestNeighborsLinear<Motion> {
 public:
  Motion nearest(const Motion& of) const override {
    const std::vector<Motion>& motions = this->data_;
    if (motions.empty()) return ompl::NearestNeighborsLinear<Motion>::nearest(of);  // its error
    constexpr double kRounding = 1e-6;                                              // [m]
    const Eigen::Vector2d place = PlaceIn(of);
    std::vector<double> least(motions.size());
    for (std::size_t i = 0; i < motions.size(); ++i)
      least[i] = (PlaceIn(motions[i]) - place).norm() - kRounding;
    auto best = static_cast<std::size_t>(std::ranges::min_element(least) - least.begin());
    double nearest = this->distFun_(motions[best], of);
    for (std::size_t i = 0; i < motions.size(); ++i) {
      if (least[i] > nearest || i == best) continue;
      const double distance = this->distFun_(motions[i], of);
      if (distance < nearest || (distance == nearest && i < best)) nearest = distance, best = i;
    }
    return motions[best];
  }

 private:
  static Eigen::Vector2d PlaceIn(const Motion& motion) {
    const auto* state = motion->state->template as<ompl::base::SE2StateSpace::StateType>();
    return {state->getX(), state->getY()};
  }
};

}  // namespace ariadne::planning::internal
