#include "slam/registration/start_search.h"

#include <algorithm>
#include <utility>

#include "slam/base/parallel.h"

namespace ariadne::slam {
namespace {

constexpr std::size_t kPoints = 500;
constexpr int kIterations = 15;

constexpr int kLatticeSteps = 2;  // from the center to the search radius

/// Distances, as shares of the search radius: the gate from the first iteration to the last, and where a
/// point is called unmatched when the results are compared.
constexpr double kFirstGate = 0.8;
constexpr double kLastGate = 0.3;
constexpr double kUnmatched = 0.1;

AlignData Thin(const AlignData& data) {
  const std::size_t stride = std::max<std::size_t>(1, data.points.size() / kPoints);
  AlignData thin;
  for (std::size_t i = 0; i < data.points.size(); i += stride) {
    thin.points.push_back(data.points[i]);
    if (!data.surfaces.empty()) thin.surfaces.push_back(data.surfaces[i]);
  }
  return thin;
}

/// The points of the lattice within the ball; the center is the first, and so wins a tie.
std::vector<Eigen::Vector3d> BallLattice(double radius) {
  constexpr int n = kLatticeSteps;
  std::vector<Eigen::Vector3d> offsets{Eigen::Vector3d::Zero()};
  for (int x = -n; x <= n; ++x) {
    for (int y = -n; y <= n; ++y) {
      for (int z = -n; z <= n; ++z) {
        const int squared = x * x + y * y + z * z;
        if (squared > 0 && squared <= n * n) offsets.push_back(radius / n * Eigen::Vector3d(x, y, z));
      }
    }
  }
  return offsets;
}

AlignOptions Coarse(AlignOptions options) {
  const double radius = std::exchange(options.search_radius, 0.0);
  options.start_distance = kFirstGate * radius;
  options.max_distance = kLastGate * radius;
  options.shrink = 0.8;
  options.kernel = RobustKernel::kNone;
  options.max_iterations = kIterations;
  options.convergence_rms = 1e-3 * radius;
  options.assess = false;
  options.guess_share = 0.0;  // a start of the lattice is no guess
  options.threads = 1;
  return options;
}

/// Sum of squared distances to the model, none counted as more than `unmatched` [m].
double Mismatch(const AlignModel& model, const AlignData& data, const Pose3& T_model_data,
                double unmatched) {
  double sum = 0.0;
  for (const Eigen::Vector3d& p : data.points) {
    const Neighbor nearest = model.tree.Nearest(T_model_data * p, unmatched);
    sum += std::min(nearest.squared_distance, unmatched * unmatched);
  }
  return sum;
}

}  // namespace

Pose3 FindStart(const AlignModel& model, const AlignData& data, const Pose3& T_model_data_guess,
                const AlignOptions& options) {
  const AlignData thin = Thin(data);
  const AlignOptions coarse = Coarse(options);
  const std::vector<Eigen::Vector3d> offsets = BallLattice(options.search_radius);
  std::vector<Pose3> results(offsets.size());
  std::vector<double> mismatches(offsets.size());
  Parallel(options.threads).For(offsets.size(), 1, [&](std::size_t begin, std::size_t, std::size_t) {
    Pose3 start = T_model_data_guess;
    start.translation += offsets[begin];
    results[begin] = Align(model, thin, start, coarse).T_model_data;
    mismatches[begin] = Mismatch(model, thin, results[begin], kUnmatched * options.search_radius);
  });
  const auto best = std::min_element(mismatches.begin(), mismatches.end());
  return results[static_cast<std::size_t>(best - mismatches.begin())];
}

}  // namespace ariadne::slam
