#include "slam/map/grid_votes.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "slam/base/error.h"

namespace ariadne::slam {
namespace {

constexpr float kDoubtful = 0.01F;  // log odds of what no scan has a point in

/// All layers from the lowest to the highest: what is above a thing's foot and below its top is of it.
Layers Filled(Layers layers) {
  if (layers == 0) return 0;
  return (~Layers{0} << std::countr_zero(layers)) & (~Layers{0} >> std::countl_zero(layers));
}

/// Where a beam shows that a thing does not go on: not in the two layers of its top, which a beam above it
/// may touch, but below; and there too if nothing is below.
Layers Within(Layers met) {
  if (met == 0) return ~Layers{0};
  const Layers top = std::bit_floor(met);
  const Layers below = (Filled(met) & ~(top | top >> 1)) | top >> 2 | top >> 3;
  return below != 0 ? below : top | top >> 1;
}

}  // namespace

GridVotes::GridVotes(const CellBox& box, const OccupancyGridOptions& options)
    : box_(box), options_(options) {
  if (box.isEmpty())
    Fail("no beam of the scans is between the heights of the grid; look at the z of the map");
  met_.assign(CellCount(box_, options.resolution), 0);
  passed_.assign(met_.size(), 0);
  grid_ = {options.resolution, options.resolution * box_.min().cast<double>(),
           static_cast<std::size_t>(box_.sizes().x() + 1), static_cast<std::size_t>(box_.sizes().y() + 1),
           std::vector<float>(met_.size(), 0.0F)};
}

/// The index of the first cell of a part's row.
std::size_t GridVotes::RowAt(const CellBox& box, int row) const {
  return IndexIn(box_, box.min() + Eigen::Vector2i(0, row));
}

void GridVotes::Meet(const GridPart& part) {
  if (part.box.isEmpty()) return;
  auto met = part.met.begin();
  for (int row = 0; row <= part.box.sizes().y(); ++row) {
    auto to = met_.begin() + static_cast<std::ptrdiff_t>(RowAt(part.box, row));
    for (int column = 0; column <= part.box.sizes().x(); ++column) *to++ |= *met++;
  }
}

void GridVotes::Vote(const GridPart& part) {
  if (part.box.isEmpty()) return;
  std::size_t from = 0;
  for (int row = 0; row <= part.box.sizes().y(); ++row) {
    std::size_t to = RowAt(part.box, row);
    for (int column = 0; column <= part.box.sizes().x(); ++column, ++from, ++to) {
      passed_[to] |= part.passed[from];
      const Layers known = met_[to] == 0 ? ~Layers{0} : Filled(met_[to]);
      const bool met = part.met[from] != 0;
      if (!met && (part.passed[from] & known) == 0) continue;
      const double vote = met ? options_.hit : -options_.miss;
      grid_.log_odds[to] = static_cast<float>(
          std::clamp(grid_.log_odds[to] + vote, -options_.most_against, options_.most_for));
    }
  }
}

/// Cells and their neighbours: a beam is as wide as that.
std::vector<std::size_t> GridVotes::Around(std::size_t cell) const {
  const std::size_t column = cell % grid_.columns, row = cell / grid_.columns;
  std::vector<std::size_t> around;
  for (std::size_t r = row - std::min<std::size_t>(row, 1); r <= std::min(row + 1, grid_.rows - 1); ++r) {
    for (std::size_t c = column - std::min<std::size_t>(column, 1);
         c <= std::min(column + 1, grid_.columns - 1); ++c)
      around.push_back(r * grid_.columns + c);
  }
  return around;
}

bool GridVotes::IsPassed(std::size_t cell, Layers layers) const {
  return std::ranges::any_of(Around(cell), [&](std::size_t near) { return (passed_[near] & layers) != 0; });
}

/// Takes the neighbours that no beam has passed at a thing's heights for occupied too, and returns them.
std::vector<GridVotes::Thing> GridVotes::Grown(const std::vector<Thing>& things) {
  std::vector<Thing> grown;
  for (const Thing& thing : things) {
    for (const std::size_t cell : Around(thing.cell)) {
      if (grid_.log_odds[cell] > 0.0F || IsPassed(cell, thing.layers)) continue;
      grid_.log_odds[cell] = kDoubtful;
      grown.push_back({cell, thing.layers});
    }
  }
  return grown;
}

OccupancyGrid GridVotes::Finish() && {
  const int steps = static_cast<int>(std::round(options_.doubt / options_.resolution));
  std::vector<Thing> things;
  for (std::size_t i = 0; steps > 0 && i < met_.size(); ++i) {
    if (grid_.log_odds[i] > 0.0F) things.push_back({i, Within(met_[i])});
  }
  for (int step = 0; step < steps; ++step) things = Grown(things);
  return std::move(grid_);
}

}  // namespace ariadne::slam
