#pragma once

#include <functional>

#include "planning/view/view_planner.h"

namespace ariadne::planning {

/// A piece of an unseen edge, and what may be found behind it by the rays of a view that meet it.
struct EdgePiece {
  std::uint32_t number = 0;
  double gain = 0.0;  // rays, or area [m^2]
};

/// What the policies choose from. The indices in `worth` are of views with enough gain and overlap.
struct ViewChoice {
  std::span<const View> views;
  std::vector<std::size_t> worth;
  std::vector<std::vector<EdgePiece>> pieces;  // that each view shows, by ascending number
  /// Of the ways between a view and each of the others, in the order that is asked for [m].
  std::function<std::vector<double>(std::size_t from, std::span<const std::size_t> to)> ways;
};

/// Whether a policy needs the pieces that the views show.
bool LooksAhead(ViewPolicy policy);

/// One of `worth`, which must not be empty; of equal ones the first.
std::size_t ChooseView(const ViewChoice& choice, const ViewPlannerOptions& options, std::uint64_t seed);

}  // namespace ariadne::planning
