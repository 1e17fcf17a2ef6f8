#pragma once

#include <string>
#include <vector>

#include "experiments/render/image.h"
#include "slam/scan/point_cloud.h"

namespace ariadne::experiments {

// Pictures of scans at their poses. `frame` decides what is in a picture, so that several can be compared.

/// From above as ink on paper, each scan in its colour: double walls show as double lines.
Image PlainTopPicture(const std::vector<slam::PosedCloud>& scans,
                      const std::vector<slam::PosedCloud>& frame, const std::string& title);

/// The same with numbered poses and a legend.
Image TopPicture(const std::vector<slam::PosedCloud>& scans, const std::vector<slam::PosedCloud>& frame,
                 const std::string& title);

/// The map at an angle, without its ceiling, coloured by height, with the path of the laser.
Image ObliquePicture(const std::vector<slam::PosedCloud>& scans, const std::string& title);

/// The same view with each scan in its colour.
Image ScanObliquePicture(const std::vector<slam::PosedCloud>& scans,
                         const std::vector<slam::PosedCloud>& frame, const std::string& title);

/// One scan as seen from behind the scanner, coloured by height, its points drawn with a radius [px].
Image ScanPicture(const slam::PosedCloud& scan, const slam::PosedCloud& frame, double radius,
                  const std::string& title);

}  // namespace ariadne::experiments
