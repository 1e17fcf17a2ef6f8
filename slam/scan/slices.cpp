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

/// Slices that begin where the angle jumps one way.
struct Candidate {
  std::vector<std::size_t> begins{0};
  double jumped = 0.0;  // sum of the jumps [rad]

  void Begin(std::size_t point, double jump) {
    begins.push_back(point);
    jumped += jump;
  }
  double MeanJump() const { return jumped / static_cast<double>(begins.size() - 1); }
};

bool IsPitchedScan(const std::vector<Eigen::Vector3d>& positions, const std::vector<std::size_t>& begins) {
  if (begins.size() < kMinSlices) return false;
  std::size_t strays = 0;
  for (std::size_t s = 0; s < begins.size(); ++s) {
    const std::size_t end = s + 1 < begins.size() ? begins[s + 1] : positions.size();
    strays += CountOutOfPlane(positions, begins[s], end);
  }
  return strays <= positions.size() / 20;  // at most 5 % stray points
}

}  // namespace

std::vector<std::size_t> InferSlices(const std::vector<Eigen::Vector3d>& positions_laser) {
  if (positions_laser.empty()) return {};
  Candidate rising;   // slices that sweep from right to left
  Candidate falling;  // and from left to right
  for (std::size_t i = 1; i < positions_laser.size(); ++i) {
    const double turn = AngleFromAxis(positions_laser[i]) - AngleFromAxis(positions_laser[i - 1]);
    if (turn < -kJumpBack) rising.Begin(i, -turn);
    if (turn > kJumpBack) falling.Begin(i, turn);
  }
  // A wall that is missing (no returns over a wide angle) is a jump too, and cuts the scan into pieces that
  // are nearly as flat as the slices; but it is narrower than the sweep that it is a part of.
  const bool is_rising = IsPitchedScan(positions_laser, rising.begins);
  const bool is_falling = IsPitchedScan(positions_laser, falling.begins);
  if (is_rising && is_falling) {
    return rising.MeanJump() > falling.MeanJump() ? rising.begins : falling.begins;
  }
  if (is_rising) return rising.begins;
  if (is_falling) return falling.begins;
  return {};
}

}  // namespace ariadne::slam
