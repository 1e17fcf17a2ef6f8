#include "drivers/simulated/fittings.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "slam/base/random.h"

namespace ariadne::drivers {
namespace {

using Eigen::Vector3d;

/// A leaf from where it grows, along a direction, as a flat ellipsoid.
TriangleMesh MakeLeaf(const Vector3d& root, const Vector3d& along, double length) {
  const auto turn = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitX(), along);
  const Vector3d radii(0.5 * length, 0.16 * length, 0.004);
  return Moved(MakeEllipsoid({0.5 * length, 0.0, 0.0}, radii, 8), {turn, root});
}

}  // namespace

Thing Make(const Radiator& radiator) {
  constexpr double kPitch = 0.06, kRib = 0.035;  // of a common rib radiator
  const double low = radiator.clearance, high = low + radiator.height, y = 0.5 * radiator.length;
  const double back = 0.03, front = back + radiator.depth;
  const double middle = 0.5 * (back + front), pipe = 0.3 * radiator.depth;
  TriangleMesh mesh = BoxBetween(middle - pipe, -y, low + 0.02, middle + pipe, y, low + 0.07);
  Append(mesh, BoxBetween(middle - pipe, -y, high - 0.07, middle + pipe, y, high - 0.02));
  const int ribs = std::max(2, static_cast<int>(radiator.length / kPitch));
  for (int i = 0; i < ribs; ++i) {
    const double center = -y + radiator.length * (i + 0.5) / ribs;
    Append(mesh, BoxBetween(back, center - 0.5 * kRib, low, front, center + 0.5 * kRib, high));
  }
  for (const double side : {-0.8 * y, 0.8 * y}) {
    Append(mesh, BoxBetween(0.0, side - 0.015, high - 0.15, back, side + 0.015, high - 0.1));
  }
  return {{"enamel", std::move(mesh)}};
}

Thing Make(const GarbageCan& can) {
  const double rim = can.radius, foot = 0.8 * can.radius, wall = 0.02 * can.radius + 0.002;
  return {{"metal", MakeRevolved({{0.0, 0.0},
                                  {foot, 0.0},
                                  {rim, can.height},
                                  {rim - wall, can.height},
                                  {foot - wall, 0.02},
                                  {0.0, 0.02}},
                                 28)}};
}

Thing Make(const Plant& plant) {
  const double rim = std::min(1.5 * plant.pot, 0.6 * plant.height), r = plant.pot;
  Part pot{
      "ceramic",
      MakeRevolved(
          {{0.0, 0.0}, {0.75 * r, 0.0}, {r, rim}, {0.9 * r, rim}, {0.9 * r, 0.9 * rim}, {0.0, 0.9 * rim}},
          24)};
  Part green{"leaf", MakeRod({0, 0, 0.85 * rim}, {0, 0, 0.85 * plant.height}, 0.02, 0.008, 8)};
  RandomStream stream = NamedStream(plant.seed, "world/plant");
  for (int i = 0; i < plant.leaves; ++i) {
    const double height = rim + (0.85 * plant.height - rim) * std::sqrt(DrawUniform(stream, 0.05, 1.0));
    const double heading = DrawUniform(stream, -std::numbers::pi, std::numbers::pi);
    const double rise = DrawUniform(stream, -0.3, 0.9);
    const Vector3d along = Vector3d(std::cos(heading), std::sin(heading), rise).normalized();
    const double length = std::min(plant.spread * DrawUniform(stream, 0.5, 1.0) / along.head<2>().norm(),
                                   (plant.height - height) / std::max(along.z(), 0.05));
    Append(green.mesh, MakeLeaf({0, 0, height}, along, std::max(length, 0.05)));
  }
  return {std::move(pot), std::move(green)};
}

Thing Make(const Person& person) {
  // Proportions of an adult of 1.75 m; a stride swings the legs from the hips, and the arms against them.
  Part trousers{"cloth", MakeEllipsoid({0.0, 0.0, 0.93}, {0.12, 0.17, 0.13})};
  Part shirt{"shirt", MakeEllipsoid({0.0, 0.0, 1.24}, {0.12, 0.18, 0.25})};
  Append(shirt.mesh, MakeEllipsoid({0.005, 0.0, 1.07}, {0.115, 0.165, 0.24}));
  Append(shirt.mesh, MakeRod({0.0, -0.17, 1.41}, {0.0, 0.17, 1.41}, 0.065, 0.065));
  Part skin{"skin", MakeEllipsoid({0.015, 0.0, 1.63}, {0.095, 0.077, 0.12})};
  Append(skin.mesh, MakeRod({-0.01, 0.0, 1.42}, {0.0, 0.0, 1.56}, 0.06, 0.055));
  Part hair{"hair", MakeEllipsoid({-0.012, 0.0, 1.655}, {0.093, 0.084, 0.105})};
  Part shoes{"rubber", {}};
  const double swing = 0.5 * person.stride * 1.75 / person.height;
  for (const double side : {-1.0, 1.0}) {
    const double foot = side * swing, hand = -0.6 * side * swing, y = 0.09 * side;
    const Vector3d hip(0.0, y, 0.90), knee(0.55 * foot + 0.02, y, 0.49), ankle(foot, y, 0.08);
    Append(trousers.mesh, MakeRod(hip, knee, 0.085, 0.065));
    Append(trousers.mesh, MakeRod(knee, ankle, 0.065, 0.05));
    Append(shoes.mesh, MakeEllipsoid({foot + 0.05, y, 0.045}, {0.14, 0.05, 0.045}, 12));
    const Vector3d shoulder(0.0, 0.18 * side, 1.41), elbow(0.5 * hand - 0.02, 0.23 * side, 1.13),
        wrist(hand + 0.05, 0.24 * side, 0.88);
    Append(shirt.mesh, MakeEllipsoid(shoulder, {0.065, 0.065, 0.065}, 12));
    Append(shirt.mesh, MakeRod(shoulder, elbow, 0.052, 0.045));
    Append(shirt.mesh, MakeRod(elbow, wrist, 0.045, 0.035));
    Append(skin.mesh, MakeEllipsoid(wrist + Vector3d(0.01, 0.0, -0.07), {0.045, 0.025, 0.09}, 12));
  }
  Thing thing{std::move(trousers), std::move(shirt), std::move(skin), std::move(hair), std::move(shoes)};
  for (Part& part : thing) {
    for (Vector3d& v : part.mesh.vertices) v *= person.height / 1.76;
  }
  return thing;
}

}  // namespace ariadne::drivers
