#pragma once

#include "experiments/render/image.h"

namespace ariadne::experiments {

inline constexpr Rgb kRed{200, 0, 0};
inline constexpr Rgb kGreen{0, 200, 0};
inline constexpr Rgb kBlue{0, 0, 200};
inline constexpr Rgb kMidGray{128, 128, 128};

}  // namespace ariadne::experiments
