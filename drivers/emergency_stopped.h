#pragma once

#include "slam/base/error.h"

namespace ariadne::drivers {

/// What a robot throws that refuses something because its emergency stop is pressed.
class EmergencyStopped : public Error {
 public:
  using Error::Error;
};

}  // namespace ariadne::drivers
