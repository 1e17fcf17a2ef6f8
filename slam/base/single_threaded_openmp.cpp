#include "slam/base/single_threaded_openmp.h"

// Of the OpenMP runtime that CHOLMOD runs on. Not <omp.h>: that comes with -fopenmp, with which Eigen
// starts threads as well.
extern "C" {
int omp_get_max_active_levels();
void omp_set_max_active_levels(int levels);
}

namespace ariadne {

// With no active level allowed, every parallel region is run by the thread that meets it alone.
SingleThreadedOpenMp::SingleThreadedOpenMp() : max_active_levels_(omp_get_max_active_levels()) {
  omp_set_max_active_levels(0);
}

SingleThreadedOpenMp::~SingleThreadedOpenMp() { omp_set_max_active_levels(max_active_levels_); }

}  // namespace ariadne
