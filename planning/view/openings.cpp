#include "planning/view/openings.h"

#include <algorithm>

namespace ariadne::planning {
namespace {

/// For each edge of a ring the length of the unseen edges that it is in a row with; 0 for seen ones.
std::vector<double> RowLengths(const LabelledRing& ring) {
  const std::size_t size = ring.size();
  const auto length = [&](std::size_t i) { return (ring[(i + 1) % size].p_map - ring[i].p_map).norm(); };
  const auto seen = std::ranges::find(ring, true, &LabelledCorner::seen);
  const auto start = seen == ring.end() ? std::size_t{0} : static_cast<std::size_t>(seen - ring.begin());
  std::vector<double> rows(size, 0.0);
  for (std::size_t k = 0; k < size;) {
    std::size_t end = k;
    double sum = 0.0;
    for (; end < size && !ring[(start + end) % size].seen; ++end) sum += length((start + end) % size);
    for (std::size_t i = k; i < end; ++i) rows[(start + i) % size] = sum;
    k = end + 1;
  }
  return rows;
}

}  // namespace

std::vector<double> Openings(std::span<const LabelledPolygon> area) {
  std::vector<double> openings;
  const auto append = [&](const LabelledRing& ring) {
    const std::vector<double> rows = RowLengths(ring);
    openings.insert(openings.end(), rows.begin(), rows.end());
  };
  for (const LabelledPolygon& polygon : area) {
    append(polygon.outer);
    for (const LabelledRing& hole : polygon.holes) append(hole);
  }
  return openings;
}

}  // namespace ariadne::planning
