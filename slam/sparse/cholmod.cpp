#include "slam/sparse/cholmod.h"

namespace ariadne::slam {

CholmodContext::CholmodContext() {
  cholmod_start(&common_);
  common_.print = 0;
  common_.error_handler = nullptr;
}

CholmodContext::~CholmodContext() { cholmod_finish(&common_); }

}  // namespace ariadne::slam
