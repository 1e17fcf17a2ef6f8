#pragma once

#include "drivers/simulated/box_world.h"
#include "drivers/simulated/world.h"
#include "slam/base/random.h"

namespace ariadne::drivers {

/// A room of random size with random boxes as furniture, some of them at a wall: what detectors of lines
/// and surfaces are measured on.
struct Room {
  BoxWorld world;
  Eigen::Vector3d size;  // the room is the box from 0 to here [m]
};

/// 4 to 8 by 4 to 7 m, 2.5 to 3.2 m high, with 6 to 11 boxes.
Room DrawRoom(RandomStream& stream);

/// A place for a scanner: at its height, and not within anything [m].
Eigen::Vector3d DrawViewpoint(RandomStream& stream, const Room& room);

/// The room with a body per box.
World ToWorld(const Room& room);

}  // namespace ariadne::drivers
