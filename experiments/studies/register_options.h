#pragma once

#include "experiments/run/scan_source.h"
#include "slam/mapper.h"

namespace ariadne::experiments {

struct OutputOptions {
  bool map = true;
  bool figures = true;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("map", self.map, "write all points of the map, map.ply");
    visit("figures", self.figures, "draw the map before and after");
  }
};

/// The experiment `register`: a folder of scans into one map.
struct RegisterOptions {
  InputOptions input;
  slam::MapperOptions mapper;
  OutputOptions output;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("input", self.input, "which scans");
    slam::MapperOptions::Visit(self.mapper, visit);
    visit("output", self.output, "what the run directory holds");
  }
};

}  // namespace ariadne::experiments
