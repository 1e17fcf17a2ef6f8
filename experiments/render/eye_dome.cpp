#include "experiments/render/eye_dome.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ariadne::experiments {
namespace {

struct Offset {
  int x = 0;
  int y = 0;
};

/// One of each pair of opposite neighbours on a circle. [px]
std::array<Offset, 4> NeighborsAt(double radius) {
  const int far = std::max(1, static_cast<int>(std::lround(radius)));
  const int diagonal = std::max(1, static_cast<int>(std::lround(radius * std::sqrt(0.5))));
  return {{{far, 0}, {diagonal, diagonal}, {0, far}, {-diagonal, diagonal}}};
}

/// Sums up how deep each pixel of a row lies in a hollow, 0 to 1: a step as far back as the neighbours are
/// aside counts 0.5. Where nothing is, a neighbour is taken to be as deep as the pixel. The loop is written
/// so that the compiler computes eight pixels at once; pixels at the picture's rim are left out.
class HollowRow {
 public:
  HollowRow(const Camera& camera, double radius)
      : neighbors_(NeighborsAt(radius)),
        is_perspective_(camera.projection == Camera::Projection::kPerspective),
        per_metre_(static_cast<float>(camera.scale / radius)),
        sums_(static_cast<std::size_t>(camera.width)) {}

  int rim() const { return neighbors_[0].x; }

  /// Row y must lie inside of the rim. Where the row shows background, the sum has no meaning.
  const std::vector<float>& Sum(const Frame& frame, int y) {
    std::fill(sums_.begin(), sums_.end(), 0.0F);
    for (const Offset& o : neighbors_) {
      Add(&frame.depth[frame.color.IndexOf(0, y)], &frame.grain[frame.color.IndexOf(0, y)],
          &frame.depth[frame.color.IndexOf(rim() + o.x, y + o.y)] - rim(),
          &frame.depth[frame.color.IndexOf(rim() - o.x, y - o.y)] - rim());
    }
    return sums_;
  }

 private:
  void Add(const float* depth, const float* grain, const float* one, const float* other) {
    const int end = static_cast<int>(sums_.size()) - rim();
    for (int x = rim(); x < end; ++x) {
      const float a = one[x] == Frame::kBackground ? depth[x] : one[x];
      const float b = other[x] == Frame::kBackground ? depth[x] : other[x];
      const float per_metre = is_perspective_ ? per_metre_ / depth[x] : per_metre_;
      const float step = std::max(0.0F, depth[x] - 0.5F * (a + b) - grain[x]) * per_metre;
      sums_[static_cast<std::size_t>(x)] += 0.25F - 0.25F / (1.0F + step * step);
    }
  }

  std::array<Offset, 4> neighbors_;
  bool is_perspective_;
  float per_metre_;  // inverse of the neighbours' distance, perspective: at a depth of 1 m
  std::vector<float> sums_;
};

}  // namespace

void ShadeEyeDome(Frame& frame, const Camera& camera, const EyeDomeOptions& options) {
  if (!(options.strength > 0.0)) return;
  HollowRow row(camera, std::max(1.0, options.radius));
  if (camera.width <= 2 * row.rim()) return;
  for (int y = row.rim(); y < camera.height - row.rim(); ++y) {
    const std::vector<float>& hollows = row.Sum(frame, y);
    for (int x = row.rim(); x < camera.width - row.rim(); ++x) {
      const std::size_t pixel = frame.color.IndexOf(x, y);
      const float hollow = hollows[static_cast<std::size_t>(x)];
      if (frame.depth[pixel] == Frame::kBackground || hollow == 0.0F) continue;
      Rgb& color = frame.color.pixels[pixel];
      color = Mix(kBlack, color, std::exp(-2.0F * static_cast<float>(options.strength) * hollow));
    }
  }
}

}  // namespace ariadne::experiments
