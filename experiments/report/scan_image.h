#pragma once

#include "experiments/render/image.h"
#include "slam/scan/scan.h"

namespace ariadne::experiments {

// What a 3D scan looks like as an image (Sec. 2.2, Fig. 2).

/// The reflectance as it was measured: a row per slice, the highest at the top, a column per beam, from
/// left to right as the scanner sees it. The scanner's rotation distorts it: what is above or beside is
/// drawn wide. Beams without a return are black. The scan must have reflectance.
Image DistortedReflectance(const slam::Scan& scan);

/// The same with the rotation taken into account: the 3D points in the perspective of a camera at the
/// scanner that looks ahead. `field_of_view` across the width [rad].
Image CorrectedReflectance(const slam::Scan& scan, int width, int height, double field_of_view);

}  // namespace ariadne::experiments
