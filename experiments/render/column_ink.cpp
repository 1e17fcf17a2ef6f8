#include "experiments/render/column_ink.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "experiments/render/percentile.h"

namespace ariadne::experiments {
namespace {

constexpr int kLayers = 64;              // one bit each
constexpr double kThinnestLayer = 0.1;   // thinner ones would count the noise of a floor as height [m]
constexpr double kOutlierShare = 0.005;  // of the depths at both ends, which do not stretch the layers

/// The range of some depths, cut into layers.
class Layers {
 public:
  explicit Layers(std::vector<double> depths) {
    nearest_ = Percentile(depths, kOutlierShare);
    const double range = Percentile(std::move(depths), 1.0 - kOutlierShare) - nearest_;
    per_metre_ = 1.0 / std::max(kThinnestLayer, range / (kLayers - 1));
  }

  std::uint64_t BitOf(double depth) const {
    const double layer = std::clamp((depth - nearest_) * per_metre_, 0.0, kLayers - 1.0);
    return std::uint64_t{1} << static_cast<unsigned>(layer);
  }

 private:
  double nearest_ = 0.0;
  double per_metre_ = 1.0;
};

/// A floor and a ceiling take a layer each, and shall be a tint behind the walls.
float InkOfLayers(int layers) {
  constexpr int kFlatLayers = 2;
  constexpr float kFlatInk = 0.3F;
  const int flat = std::min(layers, kFlatLayers);
  return static_cast<float>(layers - flat) + kFlatInk * static_cast<float>(flat);
}

/// The picture cut into squares.
class Columns {
 public:
  Columns(const Camera& camera, double side_px)
      : side_(side_px),
        per_row_(static_cast<std::size_t>(camera.width / side_px) + 1),
        columns_(per_row_ * (static_cast<std::size_t>(camera.height / side_px) + 1)) {}

  void Add(const ImagePoint& point, std::uint64_t layer) {
    Column& column = columns_[IndexOf(point)];
    column.layers |= layer;
    ++column.points;
  }

  /// The share of one of the points that have been added to the column at this place.
  float InkPerPoint(const ImagePoint& point) const {
    const Column& column = columns_[IndexOf(point)];
    return InkOfLayers(std::popcount(column.layers)) / static_cast<float>(column.points);
  }

 private:
  struct Column {
    std::uint64_t layers = 0;  // that have points, one bit each
    std::uint32_t points = 0;
  };

  std::size_t IndexOf(const ImagePoint& p) const {
    return static_cast<std::size_t>(p.v / side_) * per_row_ + static_cast<std::size_t>(p.u / side_);
  }

  double side_;          // [px]
  std::size_t per_row_;  // of the picture
  std::vector<Column> columns_;
};

}  // namespace

std::vector<float> ColumnInk(const std::vector<ImagePoint>& points, const Camera& camera, double column) {
  const auto is_inside = [&](const ImagePoint& p) {
    return p.u >= 0.0 && p.v >= 0.0 && p.u < camera.width && p.v < camera.height;
  };
  std::vector<double> depths;
  for (const ImagePoint& point : points) {
    if (is_inside(point)) depths.push_back(point.depth);
  }
  const Layers layers(std::move(depths));
  Columns columns(camera, std::max(1.0, column * camera.scale));
  for (const ImagePoint& point : points) {
    if (is_inside(point)) columns.Add(point, layers.BitOf(point.depth));
  }
  std::vector<float> ink;
  ink.reserve(points.size());
  for (const ImagePoint& point : points) {
    ink.push_back(is_inside(point) ? columns.InkPerPoint(point) : 0.0F);
  }
  return ink;
}

}  // namespace ariadne::experiments
