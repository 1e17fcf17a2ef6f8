#include "drivers/simulated/plan_furniture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "drivers/simulated/fittings.h"
#include "drivers/simulated/furniture.h"
#include "slam/base/random.h"

namespace ariadne::drivers {
namespace {

using Eigen::Vector2d;
constexpr double kPassage = 0.75;  // left free between pieces [m]
constexpr double kDoorway = 1.4;   // left free around doors and the start [m]

/// A piece, and the rectangle that it takes: half of its size along its own x and y.
struct Piece {
  std::string name;
  Thing thing;
  Vector2d half_size;
  bool at_wall;
};

Piece DrawPiece(RandomStream& stream) {
  const double which = DrawUniform(stream, 0.0, 1.0);
  if (which < 0.35) {
    Table table;
    table.length = DrawUniform(stream, 1.2, 1.8);
    Piece piece{"table", Make(table), {0.85, 0.5 * table.length}, false};
    const slam::Pose2 seat{DrawUniform(stream, -0.3, 0.3), {-0.62, DrawUniform(stream, -0.2, 0.2)}};
    for (Part& part : Make(Chair{})) {
      piece.thing.push_back({part.material, Moved(std::move(part.mesh), ToPose3(seat))});
    }
    return piece;
  }
  if (which < 0.65) {
    Shelf shelf;
    shelf.length = DrawUniform(stream, 0.8, 2.0);
    shelf.seed = stream();
    return {"shelf", Make(shelf), {0.5 * shelf.depth, 0.5 * shelf.length}, true};
  }
  if (which < 0.9) {
    const Block block{DrawUniform(stream, 0.8, 1.6), DrawUniform(stream, 0.4, 0.6),
                      DrawUniform(stream, 0.7, 1.9)};
    return {"cupboard", Make(block), {0.5 * block.depth, 0.5 * block.length}, true};
  }
  Plant plant;
  plant.seed = stream();
  return {"plant", Make(plant), {plant.spread, plant.spread}, false};
}

double DistanceTo(const PlanWall& wall, const Vector2d& p) {
  const double along = std::clamp(wall.direction().dot(p - wall.from), 0.0, wall.length());
  return (p - wall.from - along * wall.direction()).norm();
}

/// Points on the rim of the rectangle, at most 0.2 m apart, and its middle.
std::vector<Vector2d> SamplesOf(const slam::Pose2& T_map_piece, const Vector2d& half_size) {
  std::vector<Vector2d> samples{T_map_piece.translation};
  const int nx = 1 + static_cast<int>(half_size.x() / 0.1), ny = 1 + static_cast<int>(half_size.y() / 0.1);
  for (int i = -nx; i <= nx; ++i) {
    for (const double y : {-1.0, 1.0})
      samples.push_back(T_map_piece * Vector2d(half_size.x() * i / nx, half_size.y() * y));
  }
  for (int i = -ny; i <= ny; ++i) {
    for (const double x : {-1.0, 1.0})
      samples.push_back(T_map_piece * Vector2d(half_size.x() * x, half_size.y() * i / ny));
  }
  return samples;
}

double AreaOf(const std::vector<Vector2d>& outline) {
  double sum = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vector2d &p = outline[i], &q = outline[(i + 1) % outline.size()];
    sum += p.x() * q.y() - p.y() * q.x();
  }
  return 0.5 * std::abs(sum);
}

/// Puts pieces into rooms, one after the other.
class Furnisher {
 public:
  Furnisher(const FloorPlan& plan, const std::vector<PlanWall>& walls, const PlanOptions& options)
      : plan_(plan),
        walls_(walls),
        options_(options),
        stream_(NamedStream(options.seed, "world/furniture")) {}

  void Furnish(const PlanSpace& space) {
    const int pieces = static_cast<int>(AreaOf(space.outline) * options_.furniture);
    for (int i = 0; i < pieces; ++i) {
      Piece piece = DrawPiece(stream_);
      for (int attempt = 0; attempt < 30; ++attempt) {
        const slam::Pose2 T = piece.at_wall ? DrawAtWall(space, piece) : DrawInRoom(space);
        if (!Fits(space, piece, T)) continue;
        taken_.push_back({T.translation, piece.half_size.norm()});
        placed_.push_back({fmt::format("{} {}", piece.name, placed_.size()), std::move(piece.thing), T});
        break;
      }
    }
  }

  std::vector<PlacedThing> placed() { return std::move(placed_); }

 private:
  /// A round place that is no longer free.
  struct Taken {
    Vector2d center;
    double radius;
  };

  slam::Pose2 DrawAtWall(const PlanSpace& space, const Piece& piece) {
    const std::size_t n = space.outline.size();
    const std::size_t i = static_cast<std::size_t>(DrawUniform(stream_, 0.0, static_cast<double>(n)));
    const Vector2d a = space.outline[i], b = space.outline[(i + 1) % n], u = (b - a).normalized();
    const Vector2d middle = a + DrawUniform(stream_, 0.0, 1.0) * (b - a);
    Vector2d inward(-u.y(), u.x());
    if (!IsInside(space.outline, middle + 0.05 * inward)) inward = -inward;
    const double offset = piece.half_size.x() + 0.5 * options_.thickness + 0.03;
    return {std::atan2(inward.y(), inward.x()), middle + offset * inward};
  }

  slam::Pose2 DrawInRoom(const PlanSpace& space) {
    Eigen::AlignedBox2d box;
    for (const Vector2d& corner : space.outline) box.extend(corner);
    const double x = DrawUniform(stream_, box.min().x(), box.max().x());
    const double y = DrawUniform(stream_, box.min().y(), box.max().y());
    const double quarter = std::floor(DrawUniform(stream_, 0.0, 4.0));
    return {quarter * std::numbers::pi / 2.0 + DrawUniform(stream_, -0.1, 0.1), {x, y}};
  }

  bool Fits(const PlanSpace& space, const Piece& piece, const slam::Pose2& T) const {
    const double reach = piece.half_size.norm();
    const auto keeps = [&](const Vector2d& p, double free) {
      return (p - T.translation).norm() > reach + free;
    };
    if (!keeps(plan_.start, kDoorway)) return false;
    if (!std::ranges::all_of(plan_.doors, [&](const Vector2d& door) { return keeps(door, kDoorway); }))
      return false;
    const auto free_of = [&](const Taken& other) { return keeps(other.center, other.radius + kPassage); };
    if (!std::ranges::all_of(taken_, free_of)) return false;
    // Samples of the rim are 0.1 m apart: no wall slips in between them.
    const double from_wall = 0.5 * options_.thickness + (piece.at_wall ? 0.02 : 0.1);
    return std::ranges::all_of(SamplesOf(T, piece.half_size), [&](const Vector2d& p) {
      return IsInside(space.outline, p) && std::ranges::all_of(walls_, [&](const PlanWall& wall) {
               return DistanceTo(wall, p) > from_wall;
             });
    });
  }

  const FloorPlan& plan_;
  const std::vector<PlanWall>& walls_;
  const PlanOptions& options_;
  RandomStream stream_;
  std::vector<Taken> taken_;
  std::vector<PlacedThing> placed_;
};

bool StaysEmpty(const PlanSpace& space) {
  constexpr std::array kEmpty = {"corridor", "elevator", "stair", "entrance", "closet", "lobby"};
  return space.outline.size() < 3 || std::ranges::any_of(kEmpty, [&](const char* label) {
           return space.label.find(label) != std::string::npos;
         });
}

}  // namespace

std::vector<PlacedThing> FurnishPlan(const FloorPlan& plan, const std::vector<PlanWall>& walls,
                                     const PlanOptions& options) {
  if (options.furniture <= 0.0) return {};
  Furnisher furnisher(plan, walls, options);
  for (const PlanSpace& space : plan.spaces) {
    if (!StaysEmpty(space)) furnisher.Furnish(space);
  }
  return furnisher.placed();
}

}  // namespace ariadne::drivers
