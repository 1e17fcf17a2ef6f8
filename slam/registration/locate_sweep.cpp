#include "slam/registration/locate_sweep.h"

#include <Eigen/Cholesky>
#include <algorithm>

namespace ariadne::slam {
namespace {

constexpr double kUpright = 0.5;    // |n.z| below which a surface is a wall: 30 deg of slope
constexpr double kSettled = 1e-5;   // [m, rad]
constexpr double kNarrowing = 0.8;  // of the gate per iteration
constexpr double kNarrowest = 0.5;  // of the gate

/// The equations of a Gauss-Newton step, and how many beams are in them.
struct SweepEquations {
  Pose2::Square H = Pose2::Square::Zero();
  Pose2::Tangent g = Pose2::Tangent::Zero();
  std::size_t matched = 0;
};

/// Adds one beam's distance from the wall that it has met, if it has met one from the side that is known.
void AddBeam(const AlignModel& model_map, const Eigen::Vector3d& p_base, const Pose2& T_map_base,
             double gate, const LocateOptions& options, SweepEquations& sum) {
  const Eigen::Vector2d p_map = T_map_base * Eigen::Vector2d(p_base.head<2>());
  const Neighbor nearest = model_map.tree.Nearest({p_map.x(), p_map.y(), p_base.z()}, gate);
  if (nearest.index == kNoPoint) return;
  const SurfacePoint& surface = model_map.surfaces[nearest.index];
  if (!surface.has_normal() || std::abs(surface.normal.z()) > kUpright) return;
  const Eigen::Vector2d normal = surface.normal.head<2>().normalized();
  if (normal.dot(T_map_base.translation - p_map) < 0.0) return;
  const Eigen::Vector2d m_map = model_map.tree.points()[nearest.index].head<2>();
  const double residual = normal.dot(p_map - m_map);
  const Eigen::Vector2d n_base = T_map_base.RotationMatrix().transpose() * normal;
  const Pose2::Tangent J(n_base.x(), n_base.y(), n_base.dot(Eigen::Vector2d(-p_base.y(), p_base.x())));
  const double square = residual * residual / (options.sigma * options.sigma);
  const double weight = options.independent / (options.sigma * options.sigma) / (1.0 + square);
  sum.H += weight * J * J.transpose();
  sum.g += weight * residual * J;
  ++sum.matched;
}

SweepEquations GatherBeams(const AlignModel& model_map, std::span<const Eigen::Vector3d> points_base,
                           const Pose2& T_map_base, double gate, const LocateOptions& options) {
  SweepEquations sum;
  for (const Eigen::Vector3d& p_base : points_base)
    AddBeam(model_map, p_base, T_map_base, gate, options, sum);
  return sum;
}

}  // namespace

LocateResult LocateSweep(const AlignModel& model_map, std::span<const Eigen::Vector3d> points_base,
                         const Pose2& T_map_base_guess, const Pose2::Square& covariance,
                         const LocateOptions& options) {
  LocateResult result{false, T_map_base_guess, covariance, 0.0};
  if (points_base.empty()) return result;
  const Pose2::Square prior = covariance.inverse();
  Pose2 T_map_base = T_map_base_guess;
  double gate = options.max_distance;
  for (int i = 0; i < options.max_iterations; ++i) {
    const SweepEquations beams = GatherBeams(model_map, points_base, T_map_base, gate, options);
    result.matched = static_cast<double>(beams.matched) / static_cast<double>(points_base.size());
    const Pose2::Square H = beams.H + prior;
    const Pose2::Tangent off = (T_map_base_guess.Inverse() * T_map_base).Log();
    const Pose2::Tangent step = -H.ldlt().solve(beams.g + prior * off);
    if (!step.allFinite()) return result;
    T_map_base = T_map_base * Pose2::Exp(step);
    result.covariance = H.inverse();
    const bool narrow = gate <= kNarrowest * options.max_distance;
    if (narrow && step.cwiseAbs().maxCoeff() < kSettled) break;
    gate = std::max(kNarrowest * options.max_distance, kNarrowing * gate);
  }
  result.trusted = result.matched >= options.min_matched;
  if (result.trusted) {
    result.T_map_base = T_map_base;
  } else {
    result.covariance = covariance;
  }
  return result;
}

}  // namespace ariadne::slam
