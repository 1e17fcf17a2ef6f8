#pragma once

#include "control/drive_limits.h"

namespace ariadne::control {

/// The fastest speed, held for one more period [s], from which `rest` is enough to stop: [m] with [m/s] and
/// [m/s^2], or [rad] likewise. 0 without a rest.
double BrakingSpeed(double rest, double deceleration, double period);

/// Turns by `rest` [rad] in place, as fast as the motors allow, and stops there; first the wheels stop
/// rolling. It has come to its end where HasTurned.
DriveCommand TurnInPlace(double rest, const DriveCommand& before, double period, const DriveLimits& limits);

/// Whether the robot stands, or does so after the next period, within a tolerance [rad] of where it was to
/// turn.
bool HasTurned(double rest, double tolerance, const DriveCommand& before, double period,
               const DriveLimits& limits);

}  // namespace ariadne::control
