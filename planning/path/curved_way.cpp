#include "planning/path/curved_way.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "slam/geometry/angles.h"

namespace ariadne::planning {
namespace {

slam::Pose2 AlongPiece(int turn, double length) {
  if (turn == 0) return {0.0, {length, 0.0}};
  return {slam::WrapAngle(turn * length), {std::sin(length), turn * (1.0 - std::cos(length))}};
}

}  // namespace

CurvedWay::CurvedWay(const slam::Pose2& T_map_from, double turning_radius, std::vector<WayPiece> pieces)
    : T_map_from_(T_map_from), radius_(turning_radius), pieces_(std::move(pieces)) {
  for (const WayPiece& piece : pieces_) length_ += std::abs(piece.length);
}

slam::Pose2 CurvedWay::At(double s) const {
  double left = std::clamp(s, 0.0, 1.0) * length_;
  slam::Pose2 at{T_map_from_.angle, Eigen::Vector2d::Zero()};
  for (const WayPiece& piece : pieces_) {
    const double share = std::min(left, std::abs(piece.length));
    at = at * AlongPiece(piece.turn, std::copysign(share, piece.length));
    left -= share;
  }
  return {slam::WrapAngle(at.angle), T_map_from_.translation + radius_ * at.translation};
}

std::vector<slam::Pose2> CurvedWay::Sampled(double step) const {
  std::vector<slam::Pose2> poses;
  double before = 0.0;
  for (const WayPiece& piece : pieces_) {
    const int count = static_cast<int>(std::ceil(std::abs(piece.length) * radius_ / step));
    for (int i = 1; i <= count; ++i) {
      poses.push_back(At((before + std::abs(piece.length) * i / count) / length_));
    }
    before += std::abs(piece.length);
  }
  return poses;
}

}  // namespace ariadne::planning
