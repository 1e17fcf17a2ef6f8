#include "experiments/studies/robot_model.h"

#include <algorithm>

#include "drivers/simulated/solids.h"
#include "experiments/studies/tube_mesh.h"

namespace ariadne::experiments {
namespace {

using Eigen::Vector3d;
using slam::Rgb;
using slam::TriangleMesh;

constexpr Rgb kBody{214, 216, 220};
constexpr Rgb kTrim{92, 100, 112};
constexpr Rgb kDark{46, 50, 58};
constexpr Rgb kRange{52, 104, 176};  // the blue of the range finders
constexpr Rgb kSafety{226, 178, 44};
constexpr Rgb kMetal{168, 174, 182};
constexpr Rgb kStop{206, 48, 40};

constexpr double kDeckBelowTop = 0.09;  // the rest of the height is the panel at the rear [m]
constexpr double kSkirt = 0.14;         // the lowest edge of the body, above the floor [m]
constexpr double kNotch = 0.07;         // depth of the notches that the safety scanners sit in [m]

void AppendBlock(TriangleMesh& robot, const Vector3d& low, const Vector3d& high, Rgb color) {
  AppendPainted(robot, drivers::MakeBox(slam::Box3(low, high)), color);
}

/// A wheel whose axle runs across.
void AppendWheel(TriangleMesh& robot, const Vector3d& hub, double radius, double thickness) {
  const Vector3d half(0.0, 0.5 * thickness, 0.0);
  AppendBar(robot, hub - half, hub + half, radius, kDark);
  AppendBar(robot, hub - 1.06 * half, hub + 1.06 * half, 0.55 * radius, kMetal);
}

void AppendWheels(TriangleMesh& robot, const drivers::SimulatedBaseOptions& base) {
  constexpr double kCastor = 0.05;  // radius [m]
  const double radius = base.drive.wheel_radius;
  for (const double side : {-0.5, 0.5}) {
    AppendWheel(robot, {0.0, side * base.drive.track, radius}, radius, 0.05);
    for (const double end : {-0.5, 0.5}) {
      const Vector3d hub(end * (base.footprint.length - 0.22), side * (base.footprint.width - 0.16),
                         kCastor);
      AppendWheel(robot, hub, kCastor, 0.03);
      AppendBar(robot, hub + Vector3d(0.02, 0.0, 0.02), {hub.x() + 0.03, hub.y(), kSkirt + 0.02}, 0.018,
                kMetal);
    }
  }
}

/// A range finder that looks along +x or -x, its window at this height.
void AppendSafetyScanner(TriangleMesh& robot, double x, double z) {
  const double back = x > 0.0 ? x - kNotch : x + kNotch;
  const Vector3d low(std::min(x, back), -0.08, z - 0.07), high(std::max(x, back), 0.08, z + 0.07);
  AppendBlock(robot, {low.x(), low.y(), low.z()}, {high.x(), high.y(), z - 0.02}, kSafety);
  const double middle = 0.5 * (x + back);
  AppendBar(robot, {middle, 0.0, z - 0.02}, {middle, 0.0, z + 0.03}, 0.034, kDark);
  AppendBlock(robot, {low.x(), low.y(), z + 0.03}, high, kSafety);
}

void AppendBody(TriangleMesh& robot, const drivers::SimulatedRobotOptions& options) {
  const drivers::FootprintOptions& outline = options.base.footprint;
  const double x = 0.5 * outline.length, y = 0.5 * outline.width;
  const double deck = outline.highest - kDeckBelowTop, notch_top = options.safety.height + 0.09;
  AppendBlock(robot, {-x + kNotch, -y, kSkirt}, {x - kNotch, y, notch_top}, kTrim);
  AppendBlock(robot, {-x, -y, notch_top}, {x, y, deck - 0.06}, kBody);
  AppendBlock(robot, {-x + 0.02, -y + 0.02, deck - 0.06}, {x - 0.02, y - 0.02, deck - 0.04}, kTrim);
  AppendBlock(robot, {-x, -y, deck - 0.04}, {x, y, deck}, kBody);
  AppendBlock(robot, {-x, -0.2, deck}, {-x + 0.16, 0.2, outline.highest}, kBody);  // the panel
  AppendBlock(robot, {-x + 0.02, -0.08, outline.highest}, {-x + 0.14, 0.14, outline.highest + 0.004},
              kDark);
  AppendBar(robot, {-x + 0.08, -0.14, outline.highest}, {-x + 0.08, -0.14, outline.highest + 0.03}, 0.025,
            kStop);
  if (!options.safety.installed) return;
  AppendSafetyScanner(robot, options.safety.front_x, options.safety.height);
  AppendSafetyScanner(robot, options.safety.rear_x, options.safety.height);
}

/// The 2D device, whose mirror is in the origin, at pitch 0.
TriangleMesh RangeFinderMesh() {
  TriangleMesh device;
  AppendBlock(device, {-0.085, -0.0775, -0.095}, {0.06, 0.0775, -0.03}, kRange);
  AppendBar(device, {0.0, 0.0, -0.03}, {0.0, 0.0, 0.035}, 0.0725, kDark);  // the window
  AppendBlock(device, {-0.085, -0.0775, -0.03}, {-0.02, 0.0775, 0.035}, kRange);
  AppendBlock(device, {-0.085, -0.0775, 0.035}, {0.06, 0.0775, 0.09}, kRange);
  return device;
}

}  // namespace

slam::TriangleMesh ScannerMesh(double pitch) {
  constexpr double kBottom = -0.14;  // of the mount [m]
  const slam::Pose3 tilt{Eigen::Quaterniond(Eigen::AngleAxisd(-pitch, Vector3d::UnitY())),
                         Vector3d::Zero()};
  TriangleMesh scanner = drivers::Moved(RangeFinderMesh(), tilt);
  AppendBlock(scanner, {-0.12, -0.175, kBottom}, {0.12, 0.175, kBottom + 0.012}, kMetal);
  for (const double y : {-0.12, 0.108}) {
    AppendBlock(scanner, {-0.03, y, kBottom}, {0.03, y + 0.012, 0.03}, kMetal);
  }
  AppendBar(scanner, {0.0, -0.13, 0.0}, {0.0, -0.07, 0.0}, 0.016, kDark);  // the axle
  AppendBar(scanner, {0.0, 0.07, 0.0}, {0.0, 0.14, 0.0}, 0.016, kDark);
  AppendBlock(scanner, {-0.045, 0.12, -0.045}, {0.025, 0.165, 0.03}, kDark);  // the servo
  return scanner;
}

slam::TriangleMesh RobotMesh(const drivers::SimulatedRobotOptions& options, double pitch) {
  TriangleMesh robot;
  AppendWheels(robot, options.base);
  AppendBody(robot, options);
  const Vector3d axis(options.ais.mount_x, options.ais.mount_y, options.ais.mount_z);
  slam::Append(robot, drivers::Moved(ScannerMesh(pitch), {Eigen::Quaterniond::Identity(), axis}));
  return robot;
}

}  // namespace ariadne::experiments
