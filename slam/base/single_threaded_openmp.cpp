#include "slam/base/single_threaded_openmp.h"

#include <omp.h>

namespace ariadne {

// With no active level allowed, every parallel region is run by the thread that meets it alone.
SingleThreadedOpenMp::SingleThreadedOpenMp() : max_active_levels_(omp_get_max_active_levels()) {
  omp_set_max_active_levels(0);
}

SingleThreadedOpenMp::~SingleThreadedOpenMp() { omp_set_max_active_levels(max_active_levels_); }

}  // namespace ariadne
