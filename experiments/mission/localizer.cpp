#include "experiments/mission/localizer.h"

#include <cmath>

#include "experiments/mission/contact.h"

namespace ariadne::experiments {
namespace {

constexpr double kStandingPosition = 0.005;  // sigma of a registered pose, seen from above [m]
constexpr double kStandingAngle = 0.002;     // [rad]

slam::Pose2::Square DiagonalOf(double position, double angle) {
  return slam::Pose2::Tangent(position * position, position * position, angle * angle).asDiagonal();
}

}  // namespace

Localizer::Localizer(drivers::Robot& robot, const slam::Pose2& T_map_base,
                     const slam::AlignModel* model_map, const slam::ScannerModel& scanner,
                     const LocalizerOptions& options)
    : robot_(robot),
      model_map_(model_map),
      scanner_(scanner),
      options_(options),
      T_map_base_(T_map_base),
      covariance_(DiagonalOf(kStandingPosition, kStandingAngle)),
      last_(robot.State()) {}

const slam::Pose2& Localizer::Update() {
  Predict();
  const bool due = way_ > options_.every_distance || turn_ > options_.every_angle;
  if (options_.enabled && model_map_ != nullptr && due) Correct();
  return T_map_base_;
}

slam::Pose2::Square Localizer::covariance() const {
  return covariance_ + DiagonalOf(kStandingPosition, kStandingAngle);
}

void Localizer::Predict() {
  const drivers::RobotState now = robot_.State();
  const slam::Pose2 moved = last_.odometry.T_odom_base.Inverse() * now.odometry.T_odom_base;
  last_ = now;
  T_map_base_ = T_map_base_ * moved;
  const double way = moved.translation.norm(), turn = std::abs(moved.angle);
  way_ += way;
  turn_ += turn;
  const slam::Pose2::Square back = moved.Inverse().Adjoint();
  const double angle =
      std::hypot(options_.angle_by_way * std::sqrt(way), options_.angle_by_turn * std::sqrt(turn));
  covariance_ =
      back * covariance_ * back.transpose() + DiagonalOf(options_.position * std::sqrt(way), angle);
}

void Localizer::Correct() {
  way_ = turn_ = 0.0;
  const drivers::SafetySweep sweep{robot_.T_base_laser(), scanner_, robot_.TakeSweep()};
  const slam::LocateResult located =
      slam::LocateSweep(*model_map_, PointsOf(sweep, last_), T_map_base_, covariance_, options_.locate);
  if (!located.trusted) return;
  T_map_base_ = located.T_map_base;
  covariance_ = located.covariance;
  ++corrections_;
}

}  // namespace ariadne::experiments
