#include "drivers/simulated/building.h"

#include <algorithm>
#include <cmath>

namespace ariadne::drivers {
namespace {

using Eigen::Vector3d;
constexpr double kBar = 0.02;  // radius of posts and handrails [m]

/// Posts, a handrail and two bars from the origin over `run` and up by `rise`, at a constant y.
TriangleMesh MakeRailing(double run, double rise, double height, double y) {
  const Vector3d up(0.0, 0.0, height), slope(run, 0.0, rise), foot(0.0, y, 0.0);
  TriangleMesh mesh;
  const int spans = std::max(1, static_cast<int>(std::lround(run / 1.0)));
  for (int i = 0; i <= spans; ++i) {
    const Vector3d post = foot + (static_cast<double>(i) / spans) * slope;
    Append(mesh, MakeRod(post, post + up, kBar, kBar, 8));
  }
  for (const double share : {0.35, 0.7, 1.0}) {
    const double thick = share < 1.0 ? 0.5 * kBar : 1.2 * kBar;
    Append(mesh, MakeRod(foot + share * up, foot + slope + share * up, thick, thick, 8));
  }
  return mesh;
}

}  // namespace

Thing Make(const Staircase& stairs) {
  Part stone{"stone", {}}, metal{"metal", {}};
  const double y = 0.5 * stairs.width;
  for (int i = 0; i < stairs.steps; ++i) {
    const double x = i * stairs.run;
    // The nosing of a step juts out over the one below.
    Append(stone.mesh, BoxBetween(x, -y, 0.0, x + stairs.run, y, (i + 1) * stairs.rise));
    Append(stone.mesh,
           BoxBetween(x - 0.1 * stairs.run, -y, (i + 0.75) * stairs.rise, x, y, (i + 1) * stairs.rise));
  }
  if (stairs.railing > 0.0) {
    const double run = (stairs.steps - 1) * stairs.run, rise = (stairs.steps - 1) * stairs.rise;
    for (const double side : {-y + 0.05, y - 0.05}) {
      const slam::Pose3 first_step{Eigen::Quaterniond::Identity(), {0.5 * stairs.run, 0.0, stairs.rise}};
      Append(metal.mesh, Moved(MakeRailing(run, rise, stairs.railing, side), first_step));
    }
  }
  return {std::move(stone), std::move(metal)};
}

Thing Make(const Railing& railing) {
  return {{"metal", MakeRailing(railing.length, 0.0, railing.height, 0.0)}};
}

Thing Make(const Elevator& elevator) {
  const double y = 0.5 * elevator.width, h = elevator.height, d = elevator.depth;
  constexpr double kFrame = 0.12, kProud = 0.03, kWall = 0.03, kRecess = 0.06;
  Part steel{"steel", BoxBetween(-0.1, -y - kFrame, 0.0, kProud, -y, h)};
  Append(steel.mesh, BoxBetween(-0.1, y, 0.0, kProud, y + kFrame, h));
  Append(steel.mesh, BoxBetween(-0.1, -y - kFrame, h, kProud, y + kFrame, h + kFrame));
  // Leaves slide apart behind the frame.
  const double slit = std::max(0.002, 0.5 * elevator.open * elevator.width);
  Append(steel.mesh, BoxBetween(-kRecess - 0.03, -slit - y, 0.0, -kRecess, -slit, h));
  Append(steel.mesh, BoxBetween(-kRecess - 0.03, slit, 0.0, -kRecess, slit + y, h));
  Append(steel.mesh, BoxBetween(0.0, y + kFrame + 0.1, 0.95, 0.02, y + kFrame + 0.2, 1.25));
  Part cabin{"enamel", BoxBetween(-d - kWall, -y - 0.2, 0.0, -d, y + 0.2, h + 0.2)};
  for (const double side : {-y - 0.2, y + 0.2 - kWall}) {
    Append(cabin.mesh, BoxBetween(-d, side, 0.0, -0.12, side + kWall, h + 0.2));
  }
  Append(cabin.mesh, BoxBetween(-d, -y - 0.2, h + 0.2, -0.12, y + 0.2, h + 0.2 + kWall));
  return {std::move(steel), std::move(cabin)};
}

}  // namespace ariadne::drivers
