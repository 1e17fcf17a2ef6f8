#include "slam/scan/slices.h"

#include <algorithm>
#include <cmath>

#include "slam/geometry/angles.h"

namespace ariadne::slam {
namespace {

constexpr double kJumpBack = RadFromDeg(30.0);    // far above noise, far below a sweep's 100 or 180 deg
constexpr double kPitchSpread = RadFromDeg(1.0);  // a continuous tilt moves 0.5 deg in a slice
constexpr double kMinSine = 0.1;                  // nearer to the axis, the pitch of a point is ill-defined
constexpr std::size_t kMinSlices = 3;

/// 0 to the right, pi to the left.
double AngleFromAxis(const Eigen::Vector3d& p) { return std::atan2(std::hypot(p.x(), p.z()), -p.y()); }

/// Points whose pitch is more than kPitchSpread away from the pitch of the slice's middle point.
std::size_t CountOutOfPlane(const std::vector<Eigen::Vector3d>& positions, std::size_t begin,
                            std::size_t end) {
  const auto pitch = [&](std::size_t i) { return std::atan2(positions[i].z(), positions[i].x()); };
  const double middle = pitch(begin + (end - begin) / 2);
  std::size_t count = 0;
  for (std::size_t i = begin; i < end; ++i) {
    const bool measurable = std::sin(AngleFromAxis(positions[i])) > kMinSine;
    if (measurable && std::abs(WrapAngle(pitch(i) - middle)) > kPitchSpread) ++count;
  }
  return count;
}

}  // namespace

std::vector<std::size_t> InferSlices(const std::vector<Eigen::Vector3d>& positions_laser) {
  if (positions_laser.empty()) return {};
  std::vector<std::size_t> rising{0};   // slices that sweep from right to left
  std::vector<std::size_t> falling{0};  // and from left to right
  for (std::size_t i = 1; i < positions_laser.size(); ++i) {
    const double turn = AngleFromAxis(positions_laser[i]) - AngleFromAxis(positions_laser[i - 1]);
    if (turn < -kJumpBack) rising.push_back(i);
    if (turn > kJumpBack) falling.push_back(i);
  }
  // A wall that is missing (no returns over a wide angle) is a jump too, so the direction of the sweep
  // is the one that leaves the points of each slice in one plane.
  std::vector<std::size_t>* best = nullptr;
  std::size_t fewest = positions_laser.size() / 20;  // at most 5 % stray points
  for (std::vector<std::size_t>* slices : {&rising, &falling}) {
    std::size_t strays = 0;
    for (std::size_t s = 0; s < slices->size(); ++s) {
      const std::size_t end = s + 1 < slices->size() ? (*slices)[s + 1] : positions_laser.size();
      strays += CountOutOfPlane(positions_laser, (*slices)[s], end);
    }
    if (slices->size() >= kMinSlices && strays <= fewest) {
      best = slices;
      fewest = strays;
    }
  }
  return best ? *best : std::vector<std::size_t>{};
}

}  // namespace ariadne::slam
