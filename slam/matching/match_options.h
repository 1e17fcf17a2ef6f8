#pragma once

#include "slam/base/options.h"
#include "slam/graph/graph_options.h"
#include "slam/registration/options.h"

namespace ariadne::slam {

/// How a new scan is registered to those before it (Sec. 3.2).
enum class MatchMethod {
  kPairwise,      // to the earlier scan with the largest overlap
  kMetascan,      // to the union of all earlier scans
  kSimultaneous,  // pairwise first; then all scans that a motion concerns, through a queue
  kGraph,         // to several earlier scans one by one; then the poses that agree best with all alignments
  kJoint,         // pairwise first; then all scans at once, by all point pairs between them
};

/// Which points of a scan are matched.
enum class MatchPoints {
  kReduced,  // the points that `reduce` leaves (Sec. 2.2.1)
  kEdges,    // the end points of the lines in its slices (Sec. 3.3, Fig. 4c)
};

/// How closures are found: scans that might overlap, did they but lie where they could (loop_closure.h).
struct ClosureOptions {
  bool enabled = true;
  double reach = 6.0;
  double min_overlap = 0.5;
  double max_rms = 0.05;
  double confidence = 0.999;
  int max_candidates = 2;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("enabled", self.enabled, "look for scans beyond the gate that the new one may overlap");
    visit("reach", self.reach, Unit("m"), Range{0.0, 1e4},
          "farther apart than this, by more than three sigma, scans are not looked at");
    visit("min_overlap", self.min_overlap, Unit(""), Range{0.0, 1.0},
          "share of the new scan's points that must have found a pair, or the closure is refused");
    visit("max_rms", self.max_rms, Unit("m"), Range{0.0, 10.0},
          "of the closure's residuals, or it is refused: several times the noise of the scanner");
    visit("confidence", self.confidence, Unit(""), Range{0.5, 0.9999999},
          "of the chi-square bound on the difference between a closure and what the graph predicts");
    visit("max_candidates", self.max_candidates, Unit(""), Range{0, 1000},
          "that are tried for each new scan, the most likely first");
  }
};

/// What the methods graph and joint do beside the alignments.
struct ScanGraphOptions {
  double start_step = 1e-3;
  int start_partners = 4;
  int further_edges = 1;
  double odometry_position = 0.1;
  double odometry_angle = 0.05;
  double floor_height = 1e3;
  double floor_tilt = 10.0;
  double systematic_position = 0.004;
  double systematic_angle = 0.001;
  GraphRobust robust = GraphRobust::kGnc;
  ClosureOptions closure;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("start_step", self.start_step, Unit("m, rad"), Range{0.0, 1.0},
          "the alignment of a new scan ends at shorter steps: graph and joint go on from there");
    visit("start_partners", self.start_partners, Unit("scans"), Range{1, 1000000},
          "it is aligned to the union of so many scans, those that it overlaps most; one alone may mislead "
          "it");
    visit("further_edges", self.further_edges, Unit(""), Range{0, 1000},
          "graph: alignments of a new scan beside that to the scan that it overlaps most, to the next "
          "ones; more are worse: their errors are not independent, as the scan is the same in all");
    visit("odometry_position", self.odometry_position, Unit("m/m"), Range{1e-6, 1e3},
          "sigma of the odometry's position by the way between two scans, beside 5 cm; it only holds what "
          "no surface does");
    visit("odometry_angle", self.odometry_angle, Unit("rad/m"), Range{1e-6, 1e3},
          "and of its angles, beside 0.05 rad");
    visit("floor_height", self.floor_height, Unit("m"), Range{1e-6, 1e3},
          "at most this is the sigma of the height between two scans, for lasers that stand upright on an "
          "even floor");
    visit("floor_tilt", self.floor_tilt, Unit("rad"), Range{1e-6, 10.0},
          "and this of the angles about level axes: a tilt of 1 degree lifts what is 25 m away by 44 cm");
    visit("systematic_position", self.systematic_position, Unit("m"), Range{0.0, 10.0},
          "sigma that each alignment has beside its covariance: what the scanner does alike in all scans; "
          "chosen so that the positions of a few simulated tours are less overconfident (NEES)");
    visit("systematic_angle", self.systematic_angle, Unit("rad"), Range{0.0, 1.0},
          "the same of the angles");
    visit("robust", self.robust,
          "what keeps a wrong closure from bending the map, once there is a closure");
    visit("closure", self.closure, "closures of loops that have drifted beyond the gate");
  }
};

/// The iterations of the method joint: pairs, then poses, and again.
struct JointOptions {
  int pass_every = 0;
  int max_iterations = 30;
  double convergence = 1e-4;
  bool both_ways = false;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("pass_every", self.pass_every, Unit("scans"), Range{0, 1000000},
          "all scans move after every so many new ones; 0: only at the end, and after a closure");
    visit("max_iterations", self.max_iterations, Unit(""), Range{1, 10000}, "of a pass over all scans");
    visit("convergence", self.convergence, Unit("m, rad"), Range{0.0, 1.0},
          "a pass ends when no pose moves by more in translation and rotation");
    visit("both_ways", self.both_ways, "pair the points of both scans with the other's, not only one's");
  }
};

struct MatchOptions {
  MatchMethod method = MatchMethod::kSimultaneous;
  MatchPoints points = MatchPoints::kReduced;
  int overlap_pairs = 250;
  double moved_translation = 0.05;
  double moved_rotation = 0.005;
  int max_pops = 20;
  ScanGraphOptions graph;
  JointOptions joint;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("method", self.method, "the paper compares the first three (3.2, Fig. 4)");
    visit("points", self.points,
          "reduced, or the end points of lines (3.3): fast, but too few in offices; lines.* find them");
    visit("overlap_pairs", self.overlap_pairs, Unit("pairs"), Range{0, 1e9},
          "two scans overlap if they have more closest-point pairs than this within the gate (3.2: 250)");
    visit("moved_translation", self.moved_translation, Unit("m"), Range{0.0, 100.0},
          "a scan that moves farther has changed its location (2007: 5 cm; global methods later 0.1 to 0.5 "
          "cm)");
    visit("moved_rotation", self.moved_rotation, Unit("rad"), Range{0.0, 3.2},
          "or turns by more; open in the paper, 0.005 rad is 5 cm at the 10 m that a room scan reaches");
    visit("max_pops", self.max_pops, Unit("per scan"), Range{1, 1e6},
          "bound on the queue's length of work, as the paper proves no end; reached: the log says so");
    visit("graph", self.graph, "of the methods graph and joint");
    visit("joint", self.joint, "of the method joint");
  }
};

}  // namespace ariadne::slam

namespace ariadne {

template <>
struct EnumNames<slam::MatchMethod> {
  static constexpr std::array<std::string_view, 5> value{"pairwise", "metascan", "simultaneous", "graph",
                                                         "joint"};
};

template <>
struct EnumNames<slam::MatchPoints> {
  static constexpr std::array<std::string_view, 2> value{"reduced", "edges"};
};

}  // namespace ariadne
