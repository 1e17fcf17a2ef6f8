#include "planning/path/distance_transform.h"

#include <cmath>
#include <cstddef>
#include <limits>

namespace ariadne::planning {
namespace {

constexpr float kNowhere = std::numeric_limits<float>::infinity();

/// The lower envelope of parabolas with a vertex at each i of height f[i], evaluated at each i.
class ParabolaEnvelope {
 public:
  explicit ParabolaEnvelope(std::size_t size) : vertices_(size), heights_(size), from_(size) {}

  void Replace(std::vector<float>& f) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < f.size(); ++i) {
      if (f[i] != kNowhere) Add(static_cast<float>(i), f[i], count);
    }
    if (count == 0) return;
    for (std::size_t i = 0, k = 0; i < f.size(); ++i) {
      const auto at = static_cast<float>(i);
      while (k + 1 < count && from_[k + 1] <= at) ++k;
      f[i] = (at - vertices_[k]) * (at - vertices_[k]) + heights_[k];
    }
  }

 private:
  void Add(float vertex, float height, std::size_t& count) {
    float from = -kNowhere;
    for (; count > 0; --count) {
      const float other = vertices_[count - 1];
      // Where both parabolas meet; written as a product of small numbers, which keeps float exact enough.
      from = 0.5f * (vertex + other + (height - heights_[count - 1]) / (vertex - other));
      if (from > from_[count - 1]) break;
      from = -kNowhere;
    }
    vertices_[count] = vertex;
    heights_[count] = height;
    from_[count++] = from;
  }

  std::vector<float> vertices_, heights_, from_;
};

/// To the nearest marked cell of the same column [cells]. Row by row, since that is the order in memory.
std::vector<float> DistancesInColumns(const std::vector<bool>& marked, std::size_t columns) {
  std::vector<float> distance(marked.size());
  for (std::size_t i = 0; i < marked.size(); ++i) {
    distance[i] = marked[i] ? 0.0f : i < columns ? kNowhere : distance[i - columns] + 1.0f;
  }
  for (std::size_t i = marked.size() - std::min(columns, marked.size()); i-- > 0;) {
    distance[i] = std::min(distance[i], distance[i + columns] + 1.0f);
  }
  return distance;
}

}  // namespace

std::vector<float> SquaredDistances(const std::vector<bool>& marked, int columns, int rows) {
  const auto width = static_cast<std::size_t>(columns);
  std::vector<float> squares = DistancesInColumns(marked, width);
  ParabolaEnvelope envelope(width);
  std::vector<float> row(width);
  for (std::size_t r = 0; r < static_cast<std::size_t>(rows); ++r) {
    for (std::size_t i = 0; i < width; ++i) row[i] = squares[r * width + i] * squares[r * width + i];
    envelope.Replace(row);
    std::copy(row.begin(), row.end(), squares.begin() + static_cast<std::ptrdiff_t>(r * width));
  }
  return squares;
}

}  // namespace ariadne::planning
