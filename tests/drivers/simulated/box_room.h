#pragma once

#include "drivers/simulated/solids.h"

namespace ariadne::drivers {

inline Body BoxBody(const std::string& name, const Eigen::Vector3d& min, const Eigen::Vector3d& max,
                    double reflectance = 0.6) {
  return {name, MakeBox(slam::Box3(min, max)), {reflectance}, {}};
}

/// The inside of a box: floor, ceiling and four walls; surfaces have no thickness.
inline World EmptyRoom(const Eigen::Vector3d& min, const Eigen::Vector3d& max, double reflectance = 0.6) {
  World world;
  world.name = "room";
  world.bodies.push_back(BoxBody("room", min, max, reflectance));
  return world;
}

/// A room of 8 x 6 m with a pillar, a cupboard and a table of boxes.
inline World FurnishedRoom() {
  World world = EmptyRoom({-4.0, -3.0, 0.0}, {4.0, 3.0, 2.7});
  world.bodies.push_back(BoxBody("pillar", {1.5, 1.2, 0.0}, {1.8, 1.5, 2.7}));
  world.bodies.push_back(BoxBody("cupboard", {3.4, -2.0, 0.0}, {4.0, -0.8, 1.9}));
  world.bodies.push_back(BoxBody("table", {-2.5, 1.9, 0.70}, {-0.9, 2.7, 0.74}));
  world.bodies.push_back(BoxBody("leg", {-2.5, 1.9, 0.0}, {-2.44, 1.96, 0.70}));
  world.bodies.push_back(BoxBody("bin", {-3.2, -2.4, 0.0}, {-2.9, -2.1, 0.5}));
  return world;
}

}  // namespace ariadne::drivers
