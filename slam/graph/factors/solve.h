#pragma once

#include <ceres/problem.h>
#include <ceres/solver.h>

namespace ariadne::slam {

/// Options for problems of poses: sparse Cholesky by SuiteSparse, Levenberg-Marquardt whose first step is
/// that of Gauss and Newton, and no output. (Ceres' default radius, 1e4, damps the weak modes of a graph,
/// which doubles or triples the iterations.)
ceres::Solver::Options SolverOptions();

/// Solves in one thread, and without the warnings that Ceres writes to stderr. Ceres would add up costs in
/// the order in which its threads come by, so that with more of them the last digits were not reproducible;
/// on graphs of poses they gain nothing.
ceres::Solver::Summary SolveQuietly(ceres::Solver::Options options, ceres::Problem& problem);

}  // namespace ariadne::slam
