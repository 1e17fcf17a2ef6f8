#include "planning/path/motion_model.h"

#include <ompl/base/spaces/ReedsSheppStateSpace.h>

#include <algorithm>
#include <cmath>

#include "planning/path/curved_way.h"
#include "planning/path/ompl_support.h"
#include "slam/geometry/angles.h"

namespace ariadne::planning::internal {
namespace {

namespace ob = ompl::base;

constexpr double kLeastCheck = 0.02;  // [m]

/// DubinsStateSpace without its assertions (planning/path/curved_way.h).
class ForwardSpace : public ob::SE2StateSpace {
 public:
  explicit ForwardSpace(double turning_radius) : turning_radius_(turning_radius) {}
  double distance(const ob::State* from, const ob::State* to) const override {
    return DubinsWay(PoseOf(from), PoseOf(to), turning_radius_).length();
  }
  void interpolate(const ob::State* from, const ob::State* to, double s, ob::State* state) const override {
    if (s >= 1.0) return copyState(state, to);
    SetState(s <= 0.0 ? PoseOf(from) : DubinsWay(PoseOf(from), PoseOf(to), turning_radius_).At(s), state);
  }
  bool isMetricSpace() const override { return false; }
  bool hasSymmetricDistance() const override { return false; }
  bool hasSymmetricInterpolate() const override { return false; }
  void sanityChecks() const override {}  // they take each space for a metric one

 private:
  double turning_radius_;
};

std::shared_ptr<ob::SE2StateSpace> MakeStateSpace(const PathOptions& options) {
  if (options.model == PathModel::kDubins) return std::make_shared<ForwardSpace>(options.turning_radius);
  if (options.model == PathModel::kGeometric) return std::make_shared<ob::SE2StateSpace>();
  return std::make_shared<ob::ReedsSheppStateSpace>(options.turning_radius);
}

CurvedWay ReedsSheppWay(const ob::SE2StateSpace& state_space, const slam::Pose2& from,
                        const slam::Pose2& to, double turning_radius) {
  const auto give_back = [&state_space](ob::State* state) { state_space.freeState(state); };
  const std::unique_ptr<ob::State, decltype(give_back)> start(state_space.allocState(), give_back);
  const std::unique_ptr<ob::State, decltype(give_back)> goal(state_space.allocState(), give_back);
  SetState(from, start.get());
  SetState(to, goal.get());
  using Space = ob::ReedsSheppStateSpace;
  const auto way = static_cast<const Space&>(state_space).reedsShepp(start.get(), goal.get());
  std::vector<WayPiece> pieces;
  for (int i = 0; i < 5 && way.type_[i] != Space::RS_NOP; ++i) {
    const int turn = way.type_[i] == Space::RS_LEFT ? 1 : way.type_[i] == Space::RS_RIGHT ? -1 : 0;
    pieces.push_back({turn, way.length_[i]});
  }
  return {from, turning_radius, pieces};
}

}  // namespace

MotionModel::MotionModel(const FreeSpace& space, const PathOptions& options)
    : model_(options.model),
      turning_radius_(options.turning_radius),
      reach_(Footprint(options.footprint).reach()),
      state_space_(MakeStateSpace(options)) {
  state_space_->setBounds(BoundsOf(space));
}

std::vector<slam::Pose2> MotionModel::Straight(const slam::Pose2& from, const slam::Pose2& to,
                                               int count) const {
  const double turn = slam::WrapAngle(to.angle - from.angle);
  std::vector<slam::Pose2> poses;
  for (int i = 1; i <= count; ++i) {
    const double s = static_cast<double>(i) / count;
    poses.push_back({slam::WrapAngle(from.angle + s * turn),
                     from.translation + s * (to.translation - from.translation)});
  }
  return poses;
}

std::vector<slam::Pose2> MotionModel::BetweenByCorners(const slam::Pose2& from, const slam::Pose2& to,
                                                       double step) const {
  if (model_ != PathModel::kGeometric)
    return BetweenByFrame(from, to, step / (1.0 + reach_ / turning_radius_));
  const double moved = (to.translation - from.translation).norm() +
                       reach_ * std::abs(slam::WrapAngle(to.angle - from.angle));
  return Straight(from, to, std::max(1, static_cast<int>(std::ceil(moved / step))));
}

std::vector<slam::Pose2> MotionModel::BetweenByFrame(const slam::Pose2& from, const slam::Pose2& to,
                                                     double step) const {
  if (model_ == PathModel::kDubins) return DubinsWay(from, to, turning_radius_).Sampled(step);
  if (model_ == PathModel::kReedsShepp)
    return ReedsSheppWay(*state_space_, from, to, turning_radius_).Sampled(step);
  // A turn on the spot is shown as well.
  const double moved = std::max((to.translation - from.translation).norm(),
                                0.5 * std::abs(slam::WrapAngle(to.angle - from.angle)));
  return Straight(from, to, std::max(1, static_cast<int>(std::ceil(moved / step))));
}

bool IsMotionFree(const FreeSpace& space, const Footprint& footprint, const MotionModel& model,
                  const slam::Pose2& from, const slam::Pose2& to) {
  const double step = std::max(kLeastCheck, footprint.options().margin);
  return std::ranges::all_of(model.BetweenByCorners(from, to, step),
                             [&](const slam::Pose2& pose) { return footprint.IsFree(space, pose); });
}

RectangleMotions::RectangleMotions(const ob::SpaceInformationPtr& info, const FreeSpace& space,
                                   const Footprint& footprint, const MotionModel& model)
    : ob::MotionValidator(info), space_(space), footprint_(footprint), model_(model) {}

bool RectangleMotions::checkMotion(const ob::State* from, const ob::State* to) const {
  return si_->isValid(to) && IsMotionFree(space_, footprint_, model_, PoseOf(from), PoseOf(to));
}

bool RectangleMotions::checkMotion(const ob::State* from, const ob::State* to,
                                   std::pair<ob::State*, double>& last_valid) const {
  if (last_valid.first != nullptr) si_->copyState(last_valid.first, from);
  last_valid.second = 0.0;  // all or nothing: no planner that is used here asks
  return checkMotion(from, to);
}

}  // namespace ariadne::planning::internal
