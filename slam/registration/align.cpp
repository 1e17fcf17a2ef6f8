#include "slam/registration/align.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "slam/base/parallel.h"
#include "slam/registration/align_problem.h"
#include "slam/registration/start_search.h"

namespace ariadne::slam {
namespace {

constexpr const char* kSection = "icp.";  // of the options, in messages

/// The poses and errors so far, and whether there is a reason to stop.
class Progress {
 public:
  explicit Progress(const AlignOptions& options) : options_(options) {}

  void Add(const AlignIteration& iteration, const Pose3& T_model_data) {
    iterations_.push_back(iteration);
    poses_.push_back(T_model_data);
  }

  /// The rms is the same as in each of the last two iterations, or the step was short.
  bool Settled() const {
    const std::size_t n = iterations_.size();
    const AlignIteration& last = iterations_.back();
    if (last.step_translation < options_.convergence_step &&
        last.step_rotation < options_.convergence_step) {
      return true;
    }
    if (n < 3) return false;
    const auto close = [&](const AlignIteration& other) {
      return std::abs(last.rms - other.rms) <= options_.convergence_rms &&
             last.max_distance == other.max_distance;
    };
    return close(iterations_[n - 2]) && close(iterations_[n - 3]);
  }

  /// Pairs that come and go can carry the pose round in a circle for ever: it is back where it was, at the
  /// place of the circle with the smallest rms (else rounding would decide where the circle is noticed).
  bool InCycle() const {
    constexpr std::size_t kLongest = 12;
    constexpr double kSame = 1e-10;  // [m], [rad]
    for (std::size_t lag = 2; lag <= std::min(kLongest, poses_.size() - 1); ++lag) {
      const std::size_t before = poses_.size() - 1 - lag;
      if (iterations_[before].max_distance != iterations_.back().max_distance) return false;
      if (TranslationDistance(poses_[before], poses_.back()) < kSame &&
          RotationDistance(poses_[before], poses_.back()) < kSame) {
        const auto best = std::min_element(
            iterations_.begin() + static_cast<std::ptrdiff_t>(before), iterations_.end(),
            [](const AlignIteration& a, const AlignIteration& b) { return a.rms < b.rms; });
        return iterations_.back().rms <= best->rms + kSame;
      }
    }
    return false;
  }

  const std::vector<AlignIteration>& iterations() const { return iterations_; }

 private:
  const AlignOptions& options_;
  std::vector<AlignIteration> iterations_;
  std::vector<Pose3> poses_;
};

/// A sentence about input that cannot be aligned, or nothing.
std::string FindBadInput(std::string_view name, const std::vector<Eigen::Vector3d>& points) {
  if (points.empty()) return fmt::format("the {} cloud has no points", name);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].allFinite()) return fmt::format("point {} of the {} cloud is not finite", i, name);
  }
  return "";
}

void RequireUsable(std::string_view name, const std::vector<Eigen::Vector3d>& points) {
  const std::string sentence = FindBadInput(name, points);
  if (!sentence.empty()) Fail("{}", sentence);
}

AlignResult BadInput(std::string message, const Pose3& T_model_data_guess) {
  AlignResult result;
  result.message = std::move(message);
  result.T_model_data = T_model_data_guess;
  return result;
}

/// The iterations: fills pose, iterations, status and message.
AlignResult Iterate(AlignProblem& problem, const Pose3& T_model_data_guess, const AlignOptions& options,
                    const std::function<void(const AlignIteration&)>& on_iteration) {
  AlignResult result;
  Progress progress(options);
  Pose3 T_model_data = T_model_data_guess;
  double max_distance = std::max(options.start_distance, options.max_distance);
  result.status = AlignStatus::kIterationLimit;
  result.message = fmt::format("not converged after {} iterations", options.max_iterations);
  for (int k = 0; k < options.max_iterations; ++k) {
    const Improvement next = problem.Improve(T_model_data, max_distance);
    if (next.pairs < static_cast<std::size_t>(options.min_pairs)) {
      result.status = AlignStatus::kTooFewPairs;
      result.message = fmt::format(
          "{} pairs within {:.3g} m in iteration {}, at least {} are needed: the guess is too far off, or "
          "the "
          "clouds do not overlap",
          next.pairs, max_distance, k + 1, options.min_pairs);
      break;
    }
    if (!next.unique) {
      result.status = AlignStatus::kNotUnique;
      result.message =
          fmt::format("the {} pairs lie on one line, which leaves a rotation open", next.pairs);
      break;
    }
    progress.Add({max_distance, next.pairs, next.rms, TranslationDistance(T_model_data, next.T_model_data),
                  RotationDistance(T_model_data, next.T_model_data)},
                 next.T_model_data);
    T_model_data = next.T_model_data;
    if (on_iteration) on_iteration(progress.iterations().back());
    const bool settled = progress.Settled();
    if (max_distance == options.max_distance && (settled || progress.InCycle())) {
      result.status = AlignStatus::kConverged;
      result.message = fmt::format("converged after {} iterations{}", k + 1, settled ? "" : ", in a cycle");
      break;
    }
    max_distance = std::max(options.max_distance, max_distance * options.shrink);
  }
  result.T_model_data = T_model_data;
  result.iterations = progress.iterations();
  return result;
}

}  // namespace

std::string_view Name(AlignStatus status) {
  constexpr std::array<std::string_view, 6> kNames{"converged",     "degenerate", "iteration limit",
                                                   "too few pairs", "not unique", "bad input"};
  return kNames[static_cast<std::size_t>(status)];
}

bool NeedsModelSurfaces(const AlignOptions& options) {
  return options.metric != Metric::kPointToPoint || options.skip_boundary || options.one_sided;
}

bool NeedsDataSurfaces(const AlignOptions& options) {
  return options.metric == Metric::kPlaneToPlane || options.one_sided;
}

AlignModel PrepareModel(const PointCloud& model, const AlignOptions& options) {
  CheckOptions(options, kSection);
  RequireUsable("model", model.positions);
  AlignModel prepared{KdTree(model.positions), {}};
  if (NeedsModelSurfaces(options)) {
    prepared.surfaces =
        EstimateSurfaces(prepared.tree, options.normal_neighbors, Parallel(options.threads));
  }
  return prepared;
}

AlignData PrepareData(const PointCloud& data, const AlignOptions& options) {
  CheckOptions(options, kSection);
  RequireUsable("data", data.positions);
  AlignData prepared{data.positions, {}};
  if (NeedsDataSurfaces(options)) {
    prepared.surfaces =
        EstimateSurfaces(KdTree(data.positions), options.normal_neighbors, Parallel(options.threads));
  }
  return prepared;
}

AlignResult Align(const AlignModel& model, const AlignData& data, const Pose3& T_model_data_guess,
                  const AlignOptions& options,
                  const std::function<void(const AlignIteration&)>& on_iteration) {
  CheckOptions(options, kSection);
  if (!IsFinite(T_model_data_guess))
    return BadInput("the guess of the pose is not finite", T_model_data_guess);
  const Pose3 start = options.search_radius > 0.0 ? FindStart(model, data, T_model_data_guess, options)
                                                  : T_model_data_guess;
  AlignProblem problem(model, data, T_model_data_guess, options);
  AlignResult result = Iterate(problem, start, options, on_iteration);
  if (result.iterations.empty()) return result;
  result.pairs = result.iterations.back().pairs;
  result.rms = result.iterations.back().rms;
  result.overlap = static_cast<double>(result.pairs) / static_cast<double>(data.points.size());
  if (!result.converged() || !options.assess) return result;
  result.assessment = problem.Assess(result.T_model_data);
  if (result.assessment->observability.degenerate > 0) {
    result.status = AlignStatus::kDegenerate;
    result.message +=
        fmt::format(", but the surfaces do not hold the data against a motion that {} (data frame)",
                    result.assessment->observability.DescribeDegenerate());
  }
  return result;
}

AlignResult Align(const PointCloud& model, const PointCloud& data, const Pose3& T_model_data_guess,
                  const AlignOptions& options) {
  for (const auto& [name, cloud] : {std::pair("model", &model), std::pair("data", &data)}) {
    const std::string sentence = FindBadInput(name, cloud->positions);
    if (!sentence.empty()) return BadInput(sentence, T_model_data_guess);
  }
  return Align(PrepareModel(model, options), PrepareData(data, options), T_model_data_guess, options);
}

}  // namespace ariadne::slam
