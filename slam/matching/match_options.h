#pragma once

#include "slam/base/options.h"
#include "slam/registration/options.h"

namespace ariadne::slam {

/// How a new scan is registered to those before it (Sec. 3.2).
enum class MatchMethod {
  kPairwise,      // to the earlier scan with the largest overlap
  kMetascan,      // to the union of all earlier scans
  kSimultaneous,  // pairwise first; then all scans that a motion concerns, through a queue
};

struct MatchOptions {
  MatchMethod method = MatchMethod::kSimultaneous;
  int overlap_pairs = 250;
  double moved_translation = 0.05;
  double moved_rotation = 0.005;
  int max_pops = 20;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("method", self.method, "the paper compares all three (3.2, Fig. 4)");
    visit("overlap_pairs", self.overlap_pairs, Unit("pairs"), Range{0, 1e9},
          "two scans overlap if they have more closest-point pairs than this within the gate (3.2: 250)");
    visit("moved_translation", self.moved_translation, Unit("m"), Range{0.0, 100.0},
          "a scan that moves farther has changed its location (2007: 5 cm; global methods later 0.1 to 0.5 "
          "cm)");
    visit("moved_rotation", self.moved_rotation, Unit("rad"), Range{0.0, 3.2},
          "or turns by more; open in the paper, 0.005 rad is 5 cm at the 10 m that a room scan reaches");
    visit("max_pops", self.max_pops, Unit("per scan"), Range{1, 1e6},
          "bound on the queue's length of work, as the paper proves no end; reached: the log says so");
  }
};

}  // namespace ariadne::slam

namespace ariadne {

template <>
struct EnumNames<slam::MatchMethod> {
  static constexpr std::array<std::string_view, 3> value{"pairwise", "metascan", "simultaneous"};
};

}  // namespace ariadne
