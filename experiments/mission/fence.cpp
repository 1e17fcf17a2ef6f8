#include "experiments/mission/fence.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "slam/base/error.h"
#include "slam/base/numbers.h"

namespace ariadne::experiments {

std::vector<Eigen::Vector2d> FencePosts(const std::string& corners, double spacing) {
  if (corners.empty()) return {};
  std::string spaced = corners;
  std::ranges::replace(spaced, ',', ' ');
  std::string separated;
  std::istringstream words(spaced);
  for (std::string word; words >> word;) separated += (separated.empty() ? "" : ", ") + word;
  const std::vector<double> numbers = ParseNumbers(separated, "limits.fence");
  if (numbers.size() < 6 || numbers.size() % 2 != 0)
    Fail("limits.fence is \"{}\"; it takes three corners or more: x0 y0, x1 y1, x2 y2", corners);
  const std::size_t count = numbers.size() / 2;
  std::vector<Eigen::Vector2d> posts;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t next = (i + 1) % count;
    const Eigen::Vector2d from(numbers[2 * i], numbers[2 * i + 1]);
    const Eigen::Vector2d to(numbers[2 * next], numbers[2 * next + 1]);
    const int pieces = std::max(1, static_cast<int>(std::ceil((to - from).norm() / spacing)));
    for (int k = 0; k < pieces; ++k) posts.emplace_back(from + (to - from) * k / pieces);
  }
  return posts;
}

}  // namespace ariadne::experiments
