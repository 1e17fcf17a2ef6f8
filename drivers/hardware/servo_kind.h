#pragma once

#include "slam/base/options.h"

namespace ariadne::drivers {

/// What turns the scanner's mount.
enum class ServoKind { kDynamixel, kHobby };

}  // namespace ariadne::drivers

template <>
struct ariadne::EnumNames<ariadne::drivers::ServoKind> {
  static constexpr std::array<std::string_view, 2> value = {"dynamixel", "hobby"};
};
