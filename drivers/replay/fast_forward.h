#pragma once

#include "drivers/replay/robot_log.h"
#include "drivers/simulated/simulated_robot.h"

namespace ariadne::drivers {

/// Brings a simulated robot, fresh from its start, to where a log of it ends, by repeating its calls. What
/// it does then is the same, bit by bit, as if it had never been away: go on with Seam::kNone. Of the
/// measurements only the first and some others are taken again and compared, since rays cost time. Where
/// the robot does not answer as the log says, which was then written with another world, seed or version,
/// it throws an Error.
void FastForward(SimulatedRobot& robot, RobotLog& log);

/// The same with any robot that gives the same answers once more, by repeating all of its calls.
void RepeatAll(Robot& robot, RobotLog& log);

}  // namespace ariadne::drivers
