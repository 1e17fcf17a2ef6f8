#pragma once

#include <span>
#include <string_view>

namespace ariadne::experiments {

/// The program of the 3D view, made of experiments/report/web when this program was built, in pieces that
/// every compiler takes. None where it was built without npm. Holds no "</script".
std::span<const std::string_view> ViewerBundle();

}  // namespace ariadne::experiments
