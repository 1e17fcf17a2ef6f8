#pragma once

#include <cstdint>
#include <istream>
#include <string>
#include <vector>

#include "slam/geometry/pose2.h"
#include "slam/geometry/pose3.h"

namespace ariadne::slam {

// The records of a g2o file one by one, with numbers that are finite and matrices that have the meaning of
// PoseEdge; what they say together is looked at in g2o.cpp. Lines are counted from 1.

template <typename Pose>
struct G2oVertex {
  std::int64_t id = 0;
  std::size_t line = 0;
  Pose T_map_node;
};

template <typename Pose>
struct G2oEdge {
  std::int64_t from = 0;
  std::int64_t to = 0;
  std::size_t line = 0;
  Pose T_from_to;
  typename Pose::Square information;
};

template <typename Pose>
struct G2oPrior {
  std::int64_t id = 0;
  std::size_t line = 0;
  std::int64_t offset = 0;  // the number of a PARAMS_SE3OFFSET; not used in the plane
  Pose T_map_sensor;
  typename Pose::Square information;
};

struct G2oFix {
  std::int64_t id = 0;
  std::size_t line = 0;
};

/// Where a sensor sits on the vertices whose priors name it.
struct G2oOffset {
  std::int64_t id = 0;
  std::size_t line = 0;
  Pose3 T_node_sensor;
};

template <typename Pose>
struct G2oPoses {
  std::vector<G2oVertex<Pose>> vertices;
  std::vector<G2oEdge<Pose>> edges;
  std::vector<G2oPrior<Pose>> priors;
};

struct G2oRecords {
  G2oPoses<Pose2> plane;
  G2oPoses<Pose3> space;
  bool in_space = false;  // which of the two the file is; the other is empty
  std::vector<G2oFix> fixed;
  std::vector<G2oOffset> offsets;
  std::size_t skipped = 0;  // laser scans and the like
};

/// Error with file and line for every line that is not a complete record, for a record of the other kind of
/// poses, and for information that has no positive eigenvalue.
G2oRecords ReadG2oRecords(std::istream& in, const std::string& name);

}  // namespace ariadne::slam
