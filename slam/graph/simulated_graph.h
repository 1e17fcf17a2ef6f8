#pragma once

#include "slam/base/options.h"
#include "slam/graph/pose_graph.h"

namespace ariadne::slam {

/// A robot's walk on a square grid (in space: with storeys, and tilted), which measures each step, and some
/// of the places where it has been before.
struct SimulatedGraphOptions {
  int poses = 200;
  double turn_probability = 0.3;
  double closure_probability = 0.3;
  double translation_noise = 0.02;
  double rotation_noise = 0.01;
  double wrong_closures = 0.0;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("poses", self.poses, Unit(""), Range{2, 1000000}, "length of the walk");
    visit("turn_probability", self.turn_probability, Unit(""), Range{0.0, 1.0}, "at each step");
    visit("closure_probability", self.closure_probability, Unit(""), Range{0.0, 1.0},
          "that a place that is seen again is recognized");
    visit("translation_noise", self.translation_noise, Unit("m"), Range{0.0, 10.0},
          "standard deviation of a measured step of 1 m, per axis");
    visit("rotation_noise", self.rotation_noise, Unit("rad"), Range{0.0, 1.0}, "and of its angles");
    visit("wrong_closures", self.wrong_closures, Unit(""), Range{0.0, 0.95},
          "share of closures that join places which have nothing to do with each other");
  }
};

template <typename Pose>
struct SimulatedGraph {
  PoseGraph<Pose> graph;         // its nodes where odometry says; edges have the information of their noise
  std::vector<Pose> truth;       // T_map_node
  std::vector<bool> wrong_edge;  // one per edge
};

/// Draws the walk and the measurements from the seed.
template <typename Pose>
SimulatedGraph<Pose> SimulateGraph(const SimulatedGraphOptions& options, std::uint64_t seed);

}  // namespace ariadne::slam
