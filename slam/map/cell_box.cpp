#include "slam/map/cell_box.h"

#include "slam/base/error.h"

namespace ariadne::slam {

std::size_t CellCount(const CellBox& box, double resolution) {
  constexpr double kMost = 1e8;
  const double count = box.isEmpty() ? 0.0 : (box.sizes().cast<double>().array() + 1.0).prod();
  if (!(count <= kMost)) {
    const Eigen::Vector2i size = box.sizes() + Eigen::Vector2i::Ones();
    Fail("a grid of {} x {} cells of {} m is too large; use larger cells, or limit the range of the beams",
         size.x(), size.y(), resolution);
  }
  return static_cast<std::size_t>(count);
}

std::size_t IndexIn(const CellBox& box, const Eigen::Vector2i& cell) {
  const Eigen::Vector2i at = cell - box.min();
  return static_cast<std::size_t>(at.y()) * static_cast<std::size_t>(box.sizes().x() + 1) +
         static_cast<std::size_t>(at.x());
}

}  // namespace ariadne::slam
