#pragma once

#include "slam/graph/graph_options.h"

namespace ariadne::slam {

/// rho(s) of a robust kernel at a squared error s = e^T information e, and its derivatives by s. Every
/// kernel is rho(s) = s for small s: rho(0) = 0 and rho'(0) = 1, so that rho' is the weight of the edge.
struct KernelValue {
  double value = 0.0;
  double slope = 1.0;
  double curvature = 0.0;
};

/// The kernel at `squared_error`; `squared_scale` > 0 is the squared error where it begins to doubt:
///   none           s
///   huber          s up to the scale, then like the root of s
///   cauchy         c log(1 + s / c), with c the squared scale
///   geman_mcclure  c s / (c + s), which ends at c
///   dcs            s up to c, then c (3 s - c) / (c + s), which ends at 3 c: the kernel whose weight is
///   the
///                  square of Agarwal's scale min(1, 2 c / (c + s)) (Agarwal et al., ICRA 2013)
///   switchable     min over x of x^2 s + c (1 - x)^2, which is geman_mcclure, c the squared switch_weight
///   gnc            min(s, c), truncated least squares
KernelValue Evaluate(GraphRobust kernel, double squared_error, double squared_scale);

/// The squared error that a right edge with `dof` residuals stays below with probability `confidence`.
double SquaredScale(double confidence, int dof);

}  // namespace ariadne::slam
