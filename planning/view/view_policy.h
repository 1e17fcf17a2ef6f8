#pragma once

#include <functional>

#include "planning/view/view_planner.h"

namespace ariadne::planning {

/// What the policies choose from. The indices in `worth` are of views with enough gain and overlap.
struct ViewChoice {
  std::span<const View> views;
  std::vector<std::size_t> worth;
  std::vector<std::vector<std::uint32_t>> elements;  // of unseen edges, that each view shows; ascending
  std::size_t element_count = 0;
  /// Of the ways between a view and each of the others, in the order that is asked for [m].
  std::function<std::vector<double>(std::size_t from, std::span<const std::size_t> to)> ways;
};

/// Whether a policy needs the elements of the views.
bool LooksAhead(ViewPolicy policy);

/// One of `worth`, which must not be empty; of equal ones the first.
std::size_t ChooseView(const ViewChoice& choice, const ViewPlannerOptions& options, std::uint64_t seed);

/// Views that together show all elements that any of `worth` shows: greedily the one that shows most of
/// what is missing, of equal ones the first.
std::vector<std::size_t> CoveringViews(const ViewChoice& choice);

}  // namespace ariadne::planning
