#pragma once

#include "slam/geometry/rgb.h"

namespace ariadne::slam {

/// The nearest of AutoCAD's colours (ACI, 1 to 255): all that DXF of release 12 knows. What is nearly black
/// or white is 7, which programs draw as the opposite of their background.
int NearestAci(const Rgb& color);

/// The colour that a number of 1 to 255 stands for on a black background.
Rgb ColorOfAci(int number);

}  // namespace ariadne::slam
