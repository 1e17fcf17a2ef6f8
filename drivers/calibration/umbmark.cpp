#include "drivers/calibration/umbmark.h"

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "slam/base/error.h"

namespace ariadne::drivers {
namespace {

constexpr int kFewest = 3;  // squares each way
constexpr int kIterations = 20;

/// The squares of one direction.
struct SquareGroup {
  bool counterclockwise = true;
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();  // sum of squared deviations
  int count = 0;
};

SquareGroup GroupOf(std::span<const DrivenSquare> squares, bool counterclockwise) {
  SquareGroup group;
  group.counterclockwise = counterclockwise;
  for (const DrivenSquare& square : squares) {
    if (square.counterclockwise != counterclockwise) continue;
    group.mean += square.error;
    ++group.count;
  }
  if (group.count < kFewest) {
    Fail("there are {} squares {}, too few; drive at least {}, better 5, each way", group.count,
         counterclockwise ? "counterclockwise" : "clockwise", kFewest);
  }
  group.mean /= group.count;
  for (const DrivenSquare& square : squares) {
    const Eigen::Vector2d deviation = square.error - group.mean;
    if (square.counterclockwise == counterclockwise) group.scatter += deviation * deviation.transpose();
  }
  return group;
}

/// Gauss-Newton for the two factors.
class SquareSolver {
 public:
  SquareSolver(std::array<SquareGroup, 2> groups, double track, const UmbmarkOptions& options)
      : groups_(std::move(groups)), track_(track), options_(options) {
    freedom_ = groups_[0].count + groups_[1].count - 2;
    S_ = (groups_[0].scatter + groups_[1].scatter) / freedom_ +
         std::pow(options.measurement_sigma, 2) * Eigen::Matrix2d::Identity();
  }

  WheelCalibration Solve();

 private:
  Eigen::Vector2d Left(const SquareGroup& group, const Eigen::Vector2d& factors) const {
    return group.mean - SquareError(group.counterclockwise, factors[0], factors[1], options_.side, track_);
  }
  Eigen::Matrix2d JacobianOf(const SquareGroup& group, const Eigen::Vector2d& factors) const;

  std::array<SquareGroup, 2> groups_;
  double track_;
  const UmbmarkOptions& options_;
  int freedom_ = 0;
  Eigen::Matrix2d S_;  // of one square [m^2]
};

Eigen::Matrix2d SquareSolver::JacobianOf(const SquareGroup& group, const Eigen::Vector2d& factors) const {
  constexpr double kStep = 1e-6;
  Eigen::Matrix2d J;
  for (int i = 0; i < 2; ++i) {
    const Eigen::Vector2d step = kStep * Eigen::Vector2d::Unit(i);
    J.col(i) = (Left(group, factors - step) - Left(group, factors + step)) / (2.0 * kStep);
  }
  return J;
}

WheelCalibration SquareSolver::Solve() {
  Eigen::Vector2d factors(1.0, 1.0);
  Eigen::Matrix2d information;
  for (int i = 0; i < kIterations; ++i) {
    information.setZero();
    Eigen::Vector2d gradient = Eigen::Vector2d::Zero();
    for (const SquareGroup& group : groups_) {
      const Eigen::Matrix2d J = JacobianOf(group, factors);
      const Eigen::Matrix2d weight = group.count * S_.inverse();
      information += J.transpose() * weight * J;
      gradient += J.transpose() * weight * Left(group, factors);
    }
    const Eigen::Vector2d step = information.inverse() * gradient;
    factors += step.cwiseMax(-0.1).cwiseMin(0.1);
    if (step.cwiseAbs().maxCoeff() < 1e-12) break;
  }
  WheelCalibration result;
  result.ratio_factor = factors[0];
  result.track_factor = factors[1];
  // S is known from few squares only, by which its inverse is too large in the mean (Hotelling).
  result.covariance = information.inverse() * freedom_ / (freedom_ - 3.0);
  for (const SquareGroup& group : groups_) {
    const Eigen::Vector2d left = Left(group, factors);
    result.error_before = std::max(result.error_before, group.mean.norm());
    result.error_after = std::max(result.error_after, left.norm());
    result.chi2 += group.count * left.dot(S_.inverse() * left) * (freedom_ - 3.0) / freedom_;
  }
  result.scatter = std::sqrt(S_.trace());
  return result;
}

void CheckWheels(const WheelCalibration& result, const UmbmarkOptions& options) {
  const double sigma = std::sqrt(result.covariance.diagonal().maxCoeff());
  if (sigma > options.max_sigma) {
    Fail(
        "squares of one direction end {:.3f} m apart, by which the wheels remain uncertain by {:.4f}, more "
        "than {}; drive more slowly, on an even floor, and more squares",
        result.scatter, sigma, options.max_sigma);
  }
  if (result.chi2 > options.max_chi2) {
    Fail(
        "unequal wheels and a wrong track do not explain both directions (chi2 {:.0f}, more than {}); is "
        "the side {} m, and each direction, frame and sign right?",
        result.chi2, options.max_chi2, options.side);
  }
  if (std::abs(result.ratio_factor - 1.0) > options.max_ratio_error) {
    Fail(
        "wheels whose radii have a ratio of {:.4f} are not plausible (more than {} from 1); see the tyres "
        "and the list of errors",
        result.ratio_factor, options.max_ratio_error);
  }
  if (std::abs(result.track_factor - 1.0) > options.max_track_error) {
    Fail(
        "a track of {:.3f} times that of the drawing is not plausible (more than {} from 1); see "
        "drive.track and the list of errors",
        result.track_factor, options.max_track_error);
  }
}

}  // namespace

Eigen::Vector2d SquareError(bool counterclockwise, double ratio_factor, double track_factor, double side,
                            double track) {
  const double left = 2.0 / (1.0 + ratio_factor);
  const double right = ratio_factor * left;
  const double rim = (counterclockwise ? 0.25 : -0.25) * std::numbers::pi * track;  // of a quarter turn
  slam::Pose2 T_start_base;
  for (int i = 0; i < 4; ++i) {
    T_start_base = T_start_base * control::RollArc({left * side, right * side}, track_factor * track) *
                   control::RollArc({-left * rim, right * rim}, track_factor * track);
  }
  return T_start_base.translation;
}

WheelCalibration CalibrateWheels(std::span<const DrivenSquare> squares,
                                 const control::DriveGeometry& driven, const UmbmarkOptions& options) {
  CheckOptions(options, "squares.");
  CheckOptions(driven, "drive.");
  WheelCalibration result =
      SquareSolver({GroupOf(squares, true), GroupOf(squares, false)}, driven.track, options).Solve();
  CheckWheels(result, options);
  result.geometry = driven;
  result.geometry.radius_ratio *= result.ratio_factor;
  result.geometry.track *= result.track_factor;
  return result;
}

}  // namespace ariadne::drivers
