#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "planning/path/curved_way.h"

namespace ariadne::planning {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kRounding = 1e-9;

/// In [0, 2 pi); what rounding has put just below a whole turn is none.
double Positive(double angle) {
  const double within = angle - kTurn * std::floor(angle / kTurn);
  return within > kTurn - 1e-7 ? 0.0 : within;
}

struct Word {
  std::array<int, 3> turns;
  std::array<double, 3> lengths;
  double Length() const { return lengths[0] + lengths[1] + lengths[2]; }
};

/// From (0, 0, a) to (d, 0, b) with radius 1. A word that begins with a right turn is the mirror image of
/// one that begins with a left turn.
class Words {
 public:
  Words(double d, double a, double b) {
    AddMirrored(d, a, b, 1);
    AddMirrored(d, -a, -b, -1);
  }
  const Word& Shortest() const { return shortest_; }

 private:
  void Add(const Word& word) {
    if (word.Length() < shortest_.Length()) shortest_ = word;
  }

  void AddMirrored(double d, double a, double b, int left) {
    const double sa = std::sin(a), sb = std::sin(b), ca = std::cos(a), cb = std::cos(b);
    const double cab = std::cos(a - b);
    {  // left, straight, left: along the line between the centres of both circles
      const double direction = std::atan2(cb - ca, d + sa - sb);
      const double straight = std::hypot(cb - ca, d + sa - sb);
      Add({{left, 0, left}, {Positive(direction - a), straight, Positive(b - direction)}});
    }
    const double across = d * d - 2.0 + 2.0 * cab + 2.0 * d * (sa + sb);
    if (across >= -kRounding) {  // left, straight, right: the tangent that crosses that line
      const double straight = std::sqrt(std::max(0.0, across));
      const double direction = std::atan2(-ca - cb, d + sa + sb) + std::atan2(2.0, straight);
      Add({{left, 0, -left}, {Positive(direction - a), straight, Positive(direction - b)}});
    }
    const double cosine = (6.0 - d * d + 2.0 * cab + 2.0 * d * (sb - sa)) / 8.0;
    if (std::abs(cosine) <= 1.0 + kRounding) {  // left, right, left: a circle that touches both
      const double middle = kTurn - std::acos(std::clamp(cosine, -1.0, 1.0));
      const double first = Positive(std::atan2(cb - ca, d + sa - sb) - a + 0.5 * middle);
      Add({{left, -left, left}, {first, middle, Positive(b - a - first + middle)}});
    }
  }

  Word shortest_{{}, {std::numeric_limits<double>::infinity(), 0.0, 0.0}};
};

}  // namespace

CurvedWay DubinsWay(const slam::Pose2& T_map_from, const slam::Pose2& T_map_to, double turning_radius) {
  const Eigen::Vector2d between = (T_map_to.translation - T_map_from.translation) / turning_radius;
  const double direction = between.norm() > 0.0 ? std::atan2(between.y(), between.x()) : T_map_from.angle;
  const Words words(between.norm(), T_map_from.angle - direction, T_map_to.angle - direction);
  const auto& [turns, lengths] = words.Shortest();
  return {
      T_map_from, turning_radius, {{turns[0], lengths[0]}, {turns[1], lengths[1]}, {turns[2], lengths[2]}}};
}

}  // namespace ariadne::planning
