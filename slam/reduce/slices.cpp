#include "slam/base/error.h"
#include "slam/reduce/reduce.h"

namespace ariadne::slam {
namespace {

/// Points that are being joined into one.
struct Run {
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  float reflectance = 0.0F;
  int count = 0;
};

void Finish(const Run& run, bool with_reflectance, PointCloud& reduced) {
  if (run.count == 0) return;
  reduced.positions.push_back(run.sum / run.count);
  if (with_reflectance) reduced.reflectance.push_back(run.reflectance / static_cast<float>(run.count));
}

}  // namespace

PointCloud ReduceSlices(const PointCloud& cloud, double join_distance, int keep_every) {
  if (!cloud.organized() && !cloud.empty()) {
    Fail("the points are not in slices, which reduce.method=slices needs; take voxel_mean instead");
  }
  const bool with_reflectance = !cloud.reflectance.empty();
  PointCloud reduced;
  for (std::size_t s = 0; s < cloud.slice_begin.size(); s += static_cast<std::size_t>(keep_every)) {
    const std::size_t end = s + 1 < cloud.slice_begin.size() ? cloud.slice_begin[s + 1] : cloud.size();
    reduced.slice_begin.push_back(reduced.size());
    Run run;
    for (std::size_t i = cloud.slice_begin[s]; i < end; ++i) {
      const Eigen::Vector3d& p = cloud.positions[i];
      if (run.count > 0 && (p - run.first).norm() > join_distance) {
        Finish(run, with_reflectance, reduced);
        run = {};
      }
      if (run.count == 0) run.first = p;
      run.sum += p;
      if (with_reflectance) run.reflectance += cloud.reflectance[i];
      ++run.count;
    }
    Finish(run, with_reflectance, reduced);
  }
  return reduced;
}

}  // namespace ariadne::slam
