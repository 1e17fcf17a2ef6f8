#include "experiments/exploration/pieced_building.h"

#include <algorithm>
#include <cmath>

#include "slam/base/random.h"
#include "slam/geometry/polygon2.h"

namespace ariadne::experiments {
namespace {

constexpr double kUnseenShare = 0.2;

slam::Polygon2 WholeBuilding() {
  slam::Polygon2 building{{{0.0, 0.0}, {30.0, 0.0}, {30.0, 20.0}, {0.0, 20.0}}, {}};
  for (const double x : {4.0, 13.0, 22.0}) {
    for (const double y : {4.0, 12.0}) {
      building.holes.push_back({{x, y}, {x, y + 4.0}, {x + 5.0, y + 4.0}, {x + 5.0, y}});
    }
  }
  return building;
}

planning::LabelledRing InPieces(const slam::Ring& ring, double length, RandomStream& stream) {
  planning::LabelledRing pieces;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Eigen::Vector2d along = ring[(i + 1) % ring.size()] - ring[i];
    const int parts = std::max(1, static_cast<int>(std::lround(along.norm() / length)));
    for (int k = 0; k < parts; ++k) {
      pieces.push_back({ring[i] + along * k / parts, DrawUniform(stream, 0.0, 1.0) > kUnseenShare});
    }
  }
  return pieces;
}

}  // namespace

planning::LabelledPolygon PiecedBuilding(int pieces, std::uint64_t seed) {
  RandomStream stream = NamedStream(seed, "exploration/pieced_building");
  const slam::Polygon2 building = WholeBuilding();
  const double length = slam::Perimeter(building) / std::max(1, pieces);
  planning::LabelledPolygon pieced{InPieces(building.outer, length, stream), {}};
  for (const slam::Ring& hole : building.holes) pieced.holes.push_back(InPieces(hole, length, stream));
  return pieced;
}

}  // namespace ariadne::experiments
