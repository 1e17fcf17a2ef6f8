#pragma once

#include <cholmod.h>

#include <memory>

namespace ariadne::slam {

/// CHOLMOD's settings and workspace: silent, throws nothing, tells failures by its status.
class CholmodContext {
 public:
  CholmodContext();
  ~CholmodContext();
  CholmodContext(const CholmodContext&) = delete;
  CholmodContext& operator=(const CholmodContext&) = delete;

  cholmod_common* get() { return &common_; }

 private:
  cholmod_common common_;
};

struct FreeFactor {
  cholmod_common* common;
  void operator()(cholmod_factor* factor) const { cholmod_free_factor(&factor, common); }
};
using FactorPtr = std::unique_ptr<cholmod_factor, FreeFactor>;

}  // namespace ariadne::slam
