#include <algorithm>
#include <numeric>

#include "drivers/simulated/solids.h"
#include "slam/base/error.h"

namespace ariadne::drivers {
namespace {

using Index = std::uint32_t;
using Eigen::Vector2d;

/// Twice the area of the triangle; positive where it is counterclockwise.
double Cross(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

bool Contains(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& p) {
  return Cross(a, b, p) >= 0.0 && Cross(b, c, p) >= 0.0 && Cross(c, a, p) >= 0.0;
}

/// Whether the triangle at corner i of the rest can be cut off.
bool IsEar(const std::vector<Vector2d>& outline, const std::vector<Index>& rest, std::size_t i) {
  const std::size_t n = rest.size();
  const Index before = rest[(i + n - 1) % n], here = rest[i], after = rest[(i + 1) % n];
  const Vector2d &a = outline[before], &b = outline[here], &c = outline[after];
  if (Cross(a, b, c) <= 0.0) return false;
  return std::ranges::none_of(rest, [&](Index k) {
    const Vector2d& p = outline[k];
    return k != before && k != here && k != after && p != a && p != b && p != c && Contains(a, b, c, p);
  });
}

double SignedArea(const std::vector<Vector2d>& outline) {
  double sum = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    sum += Cross(outline[0], outline[i], outline[(i + 1) % outline.size()]);
  }
  return 0.5 * sum;
}

}  // namespace

std::vector<std::array<Index, 3>> Triangulate(const std::vector<Vector2d>& outline) {
  if (outline.size() < 3) Fail("an outline needs three corners, not {}", outline.size());
  std::vector<Index> rest(outline.size());
  std::iota(rest.begin(), rest.end(), 0u);
  if (SignedArea(outline) < 0.0) std::ranges::reverse(rest);
  std::vector<std::array<Index, 3>> triangles;
  while (rest.size() > 2) {
    std::size_t ear = 0;
    while (ear < rest.size() && !IsEar(outline, rest, ear)) ++ear;
    // Corners on a straight line are no ears, but cutting them off loses nothing.
    if (ear == rest.size()) {
      for (ear = 0; ear < rest.size(); ++ear) {
        const std::size_t n = rest.size();
        if (Cross(outline[rest[(ear + n - 1) % n]], outline[rest[ear]], outline[rest[(ear + 1) % n]]) ==
            0.0)
          break;
      }
    }
    if (ear == rest.size()) Fail("the outline of {} corners crosses itself", outline.size());
    const std::size_t n = rest.size();
    triangles.push_back({rest[(ear + n - 1) % n], rest[ear], rest[(ear + 1) % n]});
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  return triangles;
}

}  // namespace ariadne::drivers
