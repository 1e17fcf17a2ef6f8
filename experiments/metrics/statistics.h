#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace ariadne::experiments {

/// (1/n) sum x
double Mean(std::span<const double> values);

/// sqrt((1/n) sum x^2)
double Rms(std::span<const double> values);

/// sqrt((1/n) sum (x - mean)^2): of these values, not an estimate for those they are drawn from.
double StandardDeviation(std::span<const double> values);

/// The value below which a share p in [0, 1] of the values lies, interpolated linearly between the ordered
/// values x_0 ... x_(n-1) at the position p (n - 1): type 7 of Hyndman and Fan (1996), the default of NumPy
/// and R.
double Quantile(std::vector<double> values, double p);
double QuantileOfSorted(std::span<const double> ascending, double p);

/// The middle one, or the mean of the two in the middle.
double Median(std::vector<double> values);

/// What evo prints of a list of errors, by its definitions. All zero without values.
struct Summary {
  std::size_t count = 0;
  double rms = 0.0;
  double mean = 0.0;
  double median = 0.0;
  double standard_deviation = 0.0;
  double min = 0.0;
  double max = 0.0;
};

Summary Summarize(const std::vector<double>& values);

}  // namespace ariadne::experiments
