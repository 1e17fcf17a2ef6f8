#include "experiments/bench/plain_loop.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>
#include <tbb/task_arena.h>

#include <Eigen/SVD>
#include <cmath>
#include <nanoflann.hpp>

namespace ariadne::bench {
namespace {

struct Adaptor {
  const std::vector<Eigen::Vector3d>& points;
  std::size_t kdtree_get_point_count() const { return points.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t axis) const { return points[i][static_cast<int>(axis)]; }
  template <typename Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};
using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Adaptor>, Adaptor, 3>;

struct Sums {
  Eigen::Vector3d model = Eigen::Vector3d::Zero(), data = Eigen::Vector3d::Zero();
  Eigen::Matrix3d cross = Eigen::Matrix3d::Zero();
  double squared = 0.0, pairs = 0.0;
};

Sums Add(Sums a, const Sums& b) {
  a.model += b.model;
  a.data += b.data;
  a.cross += b.cross;
  a.squared += b.squared;
  a.pairs += b.pairs;
  return a;
}

}  // namespace

PlainResult PlainLoop(const std::vector<Eigen::Vector3d>& model, const std::vector<Eigen::Vector3d>& data,
                      const slam::Pose3& T_model_data_guess, double max_distance, double convergence_rms,
                      int threads) {
  const Adaptor adaptor{model};
  Tree tree(3, adaptor, nanoflann::KDTreeSingleIndexAdaptorParams(10));
  tree.buildIndex();
  Eigen::Matrix3d R = T_model_data_guess.RotationMatrix();
  Eigen::Vector3d t = T_model_data_guess.translation;
  const auto gather = [&](const tbb::blocked_range<std::size_t>& range, Sums sums) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      const Eigen::Vector3d p = R * data[i] + t;
      std::uint32_t nearest = 0;
      double squared = 0.0;
      tree.knnSearch(p.data(), 1, &nearest, &squared);
      if (squared >= max_distance * max_distance) continue;
      sums.model += model[nearest];
      sums.data += p;
      sums.cross += p * model[nearest].transpose();
      sums.squared += squared;
      sums.pairs += 1.0;
    }
    return sums;
  };
  tbb::task_arena arena(threads);
  double last = -1.0, before_last = -1.0;
  for (int iteration = 1;; ++iteration) {
    const tbb::blocked_range<std::size_t> all(0, data.size());
    const Sums s = threads == 1
                       ? gather(all, {})
                       : arena.execute([&] { return tbb::parallel_reduce(all, Sums{}, gather, Add); });
    const Eigen::Vector3d c_model = s.model / s.pairs, c_data = s.data / s.pairs;
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(s.cross - s.pairs * c_data * c_model.transpose(),
                                                Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Eigen::Matrix3d step = svd.matrixV() * svd.matrixU().transpose();
    R = step * R;
    t = step * (t - c_data) + c_model;
    const double rms = std::sqrt(s.squared / s.pairs);
    if (std::abs(rms - last) < convergence_rms && std::abs(rms - before_last) < convergence_rms) {
      return {{Eigen::Quaterniond(R), t}, iteration};
    }
    before_last = last;
    last = rms;
  }
}

}  // namespace ariadne::bench
