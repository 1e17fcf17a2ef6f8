#include "slam/base/blas_guard.h"

// Of the OpenMP runtime that CHOLMOD runs on. Not <omp.h>: that comes with -fopenmp, with which Eigen
// starts threads as well.
extern "C" {
int omp_get_max_active_levels();
void omp_set_max_active_levels(int levels);
}

namespace ariadne {
namespace {

std::recursive_mutex& TheMutex() {
  static std::recursive_mutex mutex;
  return mutex;
}

}  // namespace

// With no active level allowed, every parallel region is run by the thread that meets it alone.
BlasGuard::BlasGuard() : lock_(TheMutex()), max_active_levels_(omp_get_max_active_levels()) {
  omp_set_max_active_levels(0);
}

BlasGuard::~BlasGuard() { omp_set_max_active_levels(max_active_levels_); }

}  // namespace ariadne
