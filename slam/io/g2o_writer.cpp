#include "slam/base/error.h"
#include "slam/io/chunked_output.h"
#include "slam/io/g2o.h"
#include "slam/io/writable.h"

namespace ariadne::slam {
namespace {

/// What the records are called, and how their numbers are written.
struct Planar {
  static constexpr const char* kVertex = "VERTEX_SE2";
  static constexpr const char* kEdge = "EDGE_SE2";
  static constexpr const char* kPrior = "EDGE_PRIOR_SE2";

  static void PrintPose(ChunkedOutput& output, const Pose2& pose) {
    output.Print(" {} {} {}", pose.translation.x(), pose.translation.y(), pose.angle);
  }
  static Pose2::Square OfFile(const Pose2::Square& information) { return information; }
  static void CheckPose(const Pose2& pose) { CheckWritable(ToPose3(pose)); }
};

struct Spatial {
  static constexpr const char* kVertex = "VERTEX_SE3:QUAT";
  static constexpr const char* kEdge = "EDGE_SE3:QUAT";
  static constexpr const char* kPrior = "EDGE_SE3_PRIOR";

  static void PrintPose(ChunkedOutput& output, const Pose3& pose) {
    const Eigen::Vector3d& t = pose.translation;
    const Eigen::Quaterniond& q = pose.rotation;
    output.Print(" {} {} {} {} {} {} {}", t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w());
  }
  /// On half the angle.
  static Pose3::Square OfFile(Pose3::Square information) {
    information.bottomRows<3>() *= 2.0;
    information.rightCols<3>() *= 2.0;
    return information;
  }
  static void CheckPose(const Pose3& pose) { CheckWritable(pose); }
};

template <typename Square>
void PrintUpperTriangle(ChunkedOutput& output, const Square& matrix) {
  if (!matrix.allFinite()) Fail("cannot write an information matrix that is NaN or infinite");
  for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
    for (Eigen::Index column = row; column < matrix.cols(); ++column)
      output.Print(" {}", matrix(row, column));
  }
  output.Print("\n");
}

template <typename Kind, typename Pose>
void WriteVertices(ChunkedOutput& output, const PoseGraph<Pose>& graph) {
  for (const PoseNode<Pose>& node : graph.nodes) {
    Kind::CheckPose(node.T_map_node);
    output.Print("{} {}", Kind::kVertex, node.id);
    Kind::PrintPose(output, node.T_map_node);
    output.Print("\n");
  }
  for (const PoseNode<Pose>& node : graph.nodes) {
    if (node.fixed) output.Print("FIX {}\n", node.id);
  }
}

template <typename Kind, typename Pose>
void WriteEdges(ChunkedOutput& output, const PoseGraph<Pose>& graph) {
  for (const PoseEdge<Pose>& edge : graph.edges) {
    Kind::CheckPose(edge.T_from_to);
    output.Print("{} {} {}", Kind::kEdge, graph.nodes[edge.from].id, graph.nodes[edge.to].id);
    Kind::PrintPose(output, edge.T_from_to);
    PrintUpperTriangle(output, Kind::OfFile(edge.information));
  }
}

template <typename Kind, typename Pose>
void WritePriors(ChunkedOutput& output, const PoseGraph<Pose>& graph) {
  constexpr bool kHasOffset = std::is_same_v<Kind, Spatial>;
  if (kHasOffset && !graph.priors.empty()) output.Print("PARAMS_SE3OFFSET 0 0 0 0 0 0 0 1\n");
  for (const PosePrior<Pose>& prior : graph.priors) {
    Kind::CheckPose(prior.T_map_node);
    output.Print("{} {}{}", Kind::kPrior, graph.nodes[prior.node].id, kHasOffset ? " 0" : "");
    Kind::PrintPose(output, prior.T_map_node);
    PrintUpperTriangle(output, Kind::OfFile(prior.information));
  }
}

template <typename Kind, typename Pose>
void Write(std::ostream& out, const PoseGraph<Pose>& graph) {
  ChunkedOutput output(out);
  WriteVertices<Kind>(output, graph);
  WriteEdges<Kind>(output, graph);
  WritePriors<Kind>(output, graph);
  output.Flush();
}

}  // namespace

void WriteG2o(std::ostream& out, const PoseGraph2& graph) { Write<Planar>(out, graph); }
void WriteG2o(std::ostream& out, const PoseGraph3& graph) { Write<Spatial>(out, graph); }

}  // namespace ariadne::slam
