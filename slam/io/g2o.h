#pragma once

#include <istream>
#include <ostream>
#include <string>
#include <variant>
#include <vector>

#include "slam/graph/pose_graph.h"

namespace ariadne::slam {

/// A pose graph with the places in its file, so that what is found out later can be told by line.
struct G2oFile {
  std::string name;  // as in messages
  std::variant<PoseGraph2, PoseGraph3> graph;
  std::vector<std::size_t> node_lines;  // counted from 1; where the file has no vertices: of its first edge
  std::vector<std::size_t> edge_lines;
  std::vector<std::string> notes;  // what the reader has assumed or left out, as sentences
};

/// Reads the text format of g2o, or that of TORO, the elder: poses in the plane (VERTEX_SE2, EDGE_SE2,
/// EDGE_PRIOR_SE2; VERTEX2, EDGE2) or in space (VERTEX_SE3:QUAT, EDGE_SE3:QUAT, EDGE_SE3_PRIOR with
/// PARAMS_SE3OFFSET; VERTEX3, EDGE3), in m and rad, in any order; FIX holds vertices. Nodes are sorted by
/// their number.
///
/// g2o's information in space is on (translation, vec(q)), the latter half the angle; it is converted to
/// that of PoseEdge. A file without vertices gets them along its edges. A prior with an offset is moved to
/// its vertex, its information to first order.
///
/// Error with file and line for what cannot be optimized: damaged lines, NaN, vertices that are double or
/// missing, several pieces, information without any positive eigenvalue, landmarks. An information matrix
/// that is merely indefinite is read: structure.h tells such edges.
G2oFile ReadG2o(std::istream& in, const std::string& name);

/// Writes records of g2o with all digits: what is read from them is the same graph. The kind of the
/// rotation error cannot be written. Error where a number is not finite.
void WriteG2o(std::ostream& out, const PoseGraph2& graph);
void WriteG2o(std::ostream& out, const PoseGraph3& graph);

}  // namespace ariadne::slam
