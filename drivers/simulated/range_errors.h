#pragma once

#include <vector>

#include "drivers/simulated/range_finder_options.h"
#include "slam/base/random.h"

namespace ariadne::drivers {

/// The systematic error of one device over range, within +- systematic_limit: a constant, or smooth steps
/// between values that are drawn every 2 m.
class SystematicError {
 public:
  /// Draws the same number of values whatever the options, those of `stream` alone.
  SystematicError(const RangeFinderOptions& options, RandomStream stream);

  double At(double range) const;  // [m]

 private:
  std::vector<double> knots_;  // one: constant; none: no error
};

/// The range that the device reports for a measured one: rounded to the mode's unit if asked, and
/// LaserSweep::kNoReturn beyond the mode's maximum or behind the mirror [m].
float ReportedRange(double range, const RangeFinderOptions& options);

/// The reflectance that the device reports for a share of white paper's: cut at 1 and rounded to its
/// levels.
float ReportedReflectance(double share, ReflectanceOutput output);

}  // namespace ariadne::drivers
