#include "experiments/render/mask.h"

#include <algorithm>
#include <cmath>

namespace ariadne::experiments {
namespace {

/// The part of a segment, as shares of its length, inside of a box; low > high where there is none.
/// (Liang and Barsky: each side of the box cuts the segment's line once.)
struct Shares {
  double low = 0.0;
  double high = 1.0;
};

Shares SharesInside(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                    const Eigen::AlignedBox2d& box) {
  Shares inside;
  for (int axis = 0; axis < 2; ++axis) {
    const double length = to[axis] - from[axis];
    const double to_low = box.min()[axis] - from[axis];
    const double to_high = box.max()[axis] - from[axis];
    if (length == 0.0 && (to_low > 0.0 || to_high < 0.0)) return {1.0, 0.0};
    if (length == 0.0) continue;
    inside.low = std::max(inside.low, std::min(to_low / length, to_high / length));
    inside.high = std::min(inside.high, std::max(to_low / length, to_high / length));
  }
  return inside;
}

double DistanceToSegment(const Eigen::Vector2d& p, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  const Eigen::Vector2d along = to - from;
  const double length2 = along.squaredNorm();
  const double share = length2 > 0.0 ? std::clamp((p - from).dot(along) / length2, 0.0, 1.0) : 0.0;
  return (p - from - share * along).norm();
}

}  // namespace

Mask::Mask(const Image& canvas, const Eigen::AlignedBox2d& bounds)
    : pixels_(Eigen::Vector2i::Zero(), Eigen::Vector2i(canvas.width - 1, canvas.height - 1)) {
  pixels_ = PixelsIn(bounds);
  if (pixels_.isEmpty()) return;
  const Eigen::Vector2i size = pixels_.sizes() + Eigen::Vector2i::Ones();
  coverage_.assign(static_cast<std::size_t>(size.x()) * static_cast<std::size_t>(size.y()), 0.0F);
}

Eigen::AlignedBox2i Mask::PixelsIn(const Eigen::AlignedBox2d& bounds) const {
  if (pixels_.isEmpty()) return pixels_;
  // Clamped as doubles first: coordinates far outside do not fit into an int.
  const Eigen::Vector2d low = pixels_.min().cast<double>().array() - 1.0;
  const Eigen::Vector2d high = pixels_.max().cast<double>().array() + 2.0;
  const Eigen::Vector2d first = bounds.min().cwiseMax(low).cwiseMin(high);
  const Eigen::Vector2d last = bounds.max().cwiseMax(low).cwiseMin(high);
  return pixels_.intersection(Eigen::AlignedBox2i(first.array().floor().matrix().cast<int>(),
                                                  last.array().floor().matrix().cast<int>()));
}

float& Mask::At(int x, int y) {
  const int width = pixels_.sizes().x() + 1;
  return coverage_[static_cast<std::size_t>(y - pixels_.min().y()) * static_cast<std::size_t>(width) +
                   static_cast<std::size_t>(x - pixels_.min().x())];
}

void Mask::AddSegment(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double width) {
  if (pixels_.isEmpty()) return;
  const double reach = 0.5 * width + 0.5;
  Eigen::AlignedBox2d box(pixels_.min().cast<double>(), pixels_.max().cast<double>());
  box.min().array() -= reach;
  box.max().array() += reach + 1.0;
  const Shares inside = SharesInside(from, to, box);
  if (inside.low > inside.high) return;

  // A long slanted line is covered piece by piece, so that the boxes around the pieces stay small.
  constexpr double kPieceLength = 32.0;  // [px]
  const Eigen::Vector2d along = to - from;
  const double length = (inside.high - inside.low) * along.norm();
  const int pieces = std::max(1, static_cast<int>(std::ceil(length / kPieceLength)));
  const double step = (inside.high - inside.low) / pieces;
  for (int i = 0; i < pieces; ++i) {
    const Eigen::Vector2d a = from + (inside.low + i * step) * along;
    const Eigen::Vector2d b = from + (inside.low + (i + 1) * step) * along;
    Eigen::AlignedBox2d bounds(a.cwiseMin(b), a.cwiseMax(b));
    bounds.min().array() -= reach;
    bounds.max().array() += reach;
    AddShape(bounds, [&](const Eigen::Vector2d& p) { return DistanceToSegment(p, a, b) - 0.5 * width; });
  }
}

void Mask::Paint(Image& canvas, Rgb color, double opacity) const {
  if (pixels_.isEmpty()) return;
  auto covered = coverage_.begin();
  for (int y = pixels_.min().y(); y <= pixels_.max().y(); ++y) {
    for (int x = pixels_.min().x(); x <= pixels_.max().x(); ++x, ++covered) {
      Rgb& pixel = canvas.pixels[canvas.IndexOf(x, y)];
      if (*covered > 0.0F) pixel = Mix(pixel, color, opacity * *covered);
    }
  }
}

}  // namespace ariadne::experiments
