#pragma once

#include <string>

#include "slam/graph/graph_options.h"

namespace ariadne::experiments {

/// What is made small.
enum class GraphObjective { kBoth, kInformation, kIsotropic };

/// The experiment `optimize`: a pose graph from a file into its best poses.
struct OptimizeOptions {
  std::string file;
  GraphObjective objective = GraphObjective::kBoth;
  slam::GraphOptions graph;
  bool certify = false;
  bool covariances = false;
  bool figures = true;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("file", self.file, "the graph, .g2o; $ARIADNE_DATA in it stands for the environment's");
    visit("objective", self.objective,
          "information: the full matrices of the file; isotropic: a weight each for rotation and "
          "translation, "
          "as SE-Sync has it, whose minimum can be certified; both: one beside the other");
    visit("graph", self.graph, "how it is optimized");
    visit("certify", self.certify, "prove that the isotropic objective has no lower minimum");
    visit("covariances", self.covariances, "of all poses, by the Hessian at the minimum");
    visit("figures", self.figures, "draw the graph before and after");
  }
};

}  // namespace ariadne::experiments

namespace ariadne {

template <>
struct EnumNames<experiments::GraphObjective> {
  static constexpr std::array<std::string_view, 3> value{"both", "information", "isotropic"};
};

}  // namespace ariadne
