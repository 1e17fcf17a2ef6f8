#include "slam/graph/factors/solve.h"

#include <glog/logging.h>

#include "slam/base/blas_guard.h"

namespace ariadne::slam {
namespace {

/// While it lives, glog, which Ceres writes to, keeps warnings to itself.
class NoWarnings {
 public:
  NoWarnings() : level_(FLAGS_minloglevel) { FLAGS_minloglevel = google::GLOG_FATAL; }
  ~NoWarnings() { FLAGS_minloglevel = level_; }
  NoWarnings(const NoWarnings&) = delete;
  NoWarnings& operator=(const NoWarnings&) = delete;

 private:
  int level_;
};

}  // namespace

ceres::Solver::Options SolverOptions() {
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  options.sparse_linear_algebra_library_type = ceres::SUITE_SPARSE;
  options.trust_region_strategy_type = ceres::LEVENBERG_MARQUARDT;
  options.initial_trust_region_radius = 1e16;
  options.max_trust_region_radius = 1e32;
  options.logging_type = ceres::SILENT;
  return options;
}

ceres::Solver::Summary SolveQuietly(ceres::Solver::Options options, ceres::Problem& problem) {
  const BlasGuard guard;
  const NoWarnings no_warnings;
  options.num_threads = 1;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  return summary;
}

}  // namespace ariadne::slam
