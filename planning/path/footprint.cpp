#include "planning/path/footprint.h"

#include <algorithm>
#include <cmath>

namespace ariadne::planning {
namespace {

class Halving {
 public:
  Halving(const FreeSpace& space, const Eigen::Vector2d& axis, const FootprintOptions& options)
      : space_(space),
        axis_(axis),
        side_(-axis.y(), axis.x()),
        margin_(options.margin),
        smallest_(options.smallest) {}

  bool IsFree(const Eigen::Vector2d& centre, double length, double width) const {
    if (space_.IsFree(centre, 0.5 * std::hypot(length, width) + margin_)) return true;
    if (!space_.IsFree(centre, 0.5 * std::min(length, width) + margin_))
      return false;  // nor will its parts be
    if (std::max(length, width) <= smallest_) return false;
    const bool across = length >= width;
    const Eigen::Vector2d quarter = across ? 0.25 * length * axis_ : 0.25 * width * side_;
    const double half_length = across ? 0.5 * length : length, half_width = across ? width : 0.5 * width;
    return IsFree(centre + quarter, half_length, half_width) &&
           IsFree(centre - quarter, half_length, half_width);
  }

 private:
  const FreeSpace& space_;
  Eigen::Vector2d axis_, side_;
  double margin_, smallest_;
};

}  // namespace

Footprint::Footprint(const FootprintOptions& options) : options_(options) {
  CheckOptions(options, "footprint.");
  reach_ = std::hypot(std::abs(options.centre_ahead) + 0.5 * options.length, 0.5 * options.width);
}

bool Footprint::IsFree(const FreeSpace& space, const slam::Pose2& T_map_robot) const {
  return IsFree(space, T_map_robot.translation, {std::cos(T_map_robot.angle), std::sin(T_map_robot.angle)});
}

bool Footprint::IsFree(const FreeSpace& space, const Eigen::Vector2d& p_map,
                       const Eigen::Vector2d& heading) const {
  const Eigen::Vector2d centre = p_map + options_.centre_ahead * heading;
  return Halving(space, heading, options_).IsFree(centre, options_.length, options_.width);
}

std::vector<Eigen::Vector2d> Footprint::CornersAt(const slam::Pose2& T_map_robot) const {
  const double front = options_.centre_ahead + 0.5 * options_.length, back = front - options_.length;
  const double left = 0.5 * options_.width;
  return {T_map_robot * Eigen::Vector2d(back, -left), T_map_robot * Eigen::Vector2d(front, -left),
          T_map_robot * Eigen::Vector2d(front, left), T_map_robot * Eigen::Vector2d(back, left)};
}

double Footprint::least_radius() const {
  return 0.5 * std::min(options_.width, options_.length) + options_.margin;
}

}  // namespace ariadne::planning
