#include "slam/registration/correspondences.h"

#include <algorithm>
#include <cmath>

namespace ariadne::slam {
namespace {

constexpr Eigen::Index kBlock = 1024;  // 24 kB of coordinates

Correspondences Unpaired(std::size_t count) {
  return {std::vector<std::uint32_t>(count, kNoPoint), std::vector<double>(count, 0.0)};
}

void Store(const Neighbor& neighbor, std::size_t i, Correspondences& pairs) {
  pairs.model_index[i] = neighbor.index;
  pairs.squared_distance[i] = neighbor.squared_distance;
}

}  // namespace

Correspondences FindByBruteForce(const std::vector<Eigen::Vector3d>& model,
                                 const std::vector<Eigen::Vector3d>& data, const Pose3& T_model_data,
                                 double max_distance, const Parallel& parallel) {
  // Coordinates in three arrays, walked in blocks that stay in the first cache while many data points are
  // compared with them: the compiler makes the inner loop as wide as the machine.
  const Eigen::Map<const Eigen::Matrix3Xd> points(model.empty() ? nullptr : model.front().data(), 3,
                                                  static_cast<Eigen::Index>(model.size()));
  const Eigen::ArrayXd x = points.row(0), y = points.row(1), z = points.row(2);
  Correspondences pairs = Unpaired(data.size());
  const Eigen::Matrix3d R = T_model_data.RotationMatrix();
  parallel.For(data.size(), kPairsPerChunk, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (Eigen::Index block = 0; block < x.size(); block += kBlock) {
      const Eigen::Index width = std::min(kBlock, x.size() - block);
      const auto bx = x.segment(block, width), by = y.segment(block, width), bz = z.segment(block, width);
      for (std::size_t i = begin; i < end; ++i) {
        const Eigen::Vector3d p = R * data[i] + T_model_data.translation;
        const auto squared = (bx - p.x()).square() + (by - p.y()).square() + (bz - p.z()).square();
        const double bound =
            pairs.model_index[i] == kNoPoint ? max_distance * max_distance : pairs.squared_distance[i];
        if (!(squared.minCoeff() < bound)) continue;
        Eigen::Index nearest = 0;
        const double squared_distance = squared.minCoeff(&nearest);
        Store({static_cast<std::uint32_t>(block + nearest), squared_distance}, i, pairs);
      }
    }
  });
  return pairs;
}

Correspondences FindByKdTree(const KdTree& model, const std::vector<Eigen::Vector3d>& data,
                             const Pose3& T_model_data, double max_distance, const Parallel& parallel) {
  Correspondences pairs = Unpaired(data.size());
  const Eigen::Matrix3d R = T_model_data.RotationMatrix();
  parallel.For(data.size(), kPairsPerChunk, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) {
      Store(model.Nearest(R * data[i] + T_model_data.translation, max_distance), i, pairs);
    }
  });
  return pairs;
}

}  // namespace ariadne::slam
