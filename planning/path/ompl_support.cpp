#include "planning/path/ompl_support.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numbers>

#include "slam/geometry/angles.h"

namespace ariadne::planning::internal {
namespace {

namespace ob = ompl::base;

using PlaneState = ob::RealVectorStateSpace::StateType;

class PlaneSampler : public ob::StateSampler {
 public:
  PlaneSampler(const ob::StateSpace* space, RandomStream stream)
      : ob::StateSampler(space), stream_(stream) {}

  void sampleUniform(ob::State* state) override {
    const ob::RealVectorBounds& bounds = space_->as<ob::RealVectorStateSpace>()->getBounds();
    for (unsigned i = 0; i < 2; ++i)
      (*state->as<PlaneState>())[i] = DrawUniform(stream_, bounds.low[i], bounds.high[i]);
  }
  void sampleUniformNear(ob::State* state, const ob::State* near, double distance) override {
    for (unsigned i = 0; i < 2; ++i) {
      const double middle = (*near->as<PlaneState>())[i];
      (*state->as<PlaneState>())[i] = DrawUniform(stream_, middle - distance, middle + distance);
    }
    space_->enforceBounds(state);
  }
  void sampleGaussian(ob::State* state, const ob::State* mean, double std_dev) override {
    for (unsigned i = 0; i < 2; ++i) {
      (*state->as<PlaneState>())[i] = DrawNormal(stream_, (*mean->as<PlaneState>())[i], std_dev);
    }
    space_->enforceBounds(state);
  }

 private:
  RandomStream stream_;
};

class DiscChecker : public ob::StateValidityChecker {
 public:
  DiscChecker(const ob::SpaceInformationPtr& info, const FreeSpace& space, double radius)
      : ob::StateValidityChecker(info), space_(space), radius_(radius) {}
  bool isValid(const ob::State* state) const override { return space_.IsFree(PlaceOf(state), radius_); }
  double clearance(const ob::State* state) const override {
    return space_.Clearance(PlaceOf(state)) - radius_;
  }

 private:
  const FreeSpace& space_;
  double radius_;
};

class DiscMotions : public ob::MotionValidator {
 public:
  DiscMotions(const ob::SpaceInformationPtr& info, const FreeSpace& space, double radius)
      : ob::MotionValidator(info), space_(space), radius_(radius) {}
  bool checkMotion(const ob::State* from, const ob::State* to) const override {
    return space_.IsWayFree(PlaceOf(from), PlaceOf(to), radius_);
  }
  /// The obstacle-based sampler takes the last place that is free.
  bool checkMotion(const ob::State* from, const ob::State* to,
                   std::pair<ob::State*, double>& last_valid) const override {
    if (checkMotion(from, to)) return true;
    const Eigen::Vector2d start = PlaceOf(from), way = PlaceOf(to) - start;
    const double step = 0.25 * space_.resolution(), length = way.norm();
    double at = 0.0;
    while (at + step < length && space_.IsFree(start + (at + step) / length * way, radius_)) at += step;
    last_valid.second = length > 0.0 ? at / length : 0.0;
    const ob::StateSpace& plane = *si_->getStateSpace();
    if (last_valid.first != nullptr) plane.interpolate(from, to, last_valid.second, last_valid.first);
    return false;
  }

 private:
  const FreeSpace& space_;
  double radius_;
};

/// Those that are silent now, in any thread: OMPL has one output for all.
struct Silent {
  std::mutex mutex;
  int count = 0;
  ompl::msg::OutputHandler* before = nullptr;
};

Silent& TheSilent() {
  static Silent silent;
  return silent;
}

}  // namespace

OmplSilence::OmplSilence() {
  Silent& silent = TheSilent();
  const std::scoped_lock lock(silent.mutex);
  if (silent.count++ > 0) return;
  silent.before = ompl::msg::getOutputHandler();
  ompl::msg::noOutputHandler();
}

OmplSilence::~OmplSilence() {
  Silent& silent = TheSilent();
  const std::scoped_lock lock(silent.mutex);
  if (--silent.count == 0) ompl::msg::useOutputHandler(silent.before);
}

void RequireRadius(double radius) {
  if (radius >= 0.0 && std::isfinite(radius)) return;
  Fail("the robot's radius is {} m, but must be finite and not negative", radius);
}

std::uint_fast32_t OmplSeed(std::uint64_t seed, std::string_view name) {
  RandomStream stream = NamedStream(seed, name);
  return static_cast<std::uint_fast32_t>(1 + (stream() >> 33));  // OMPL takes 0 for none
}

void SetState(const slam::Pose2& T_map_robot, ob::State* state) {
  auto* pose = state->as<ob::SE2StateSpace::StateType>();
  const double yaw = slam::WrapAngle(T_map_robot.angle);
  pose->setXY(T_map_robot.translation.x(), T_map_robot.translation.y());
  pose->setYaw(yaw < std::numbers::pi ? yaw : -std::numbers::pi);
}

slam::Pose2 PoseOf(const ob::State* state) {
  const auto* pose = state->as<ob::SE2StateSpace::StateType>();
  return {slam::WrapAngle(pose->getYaw()), {pose->getX(), pose->getY()}};
}

ob::RealVectorBounds BoundsOf(const FreeSpace& space) {
  ob::RealVectorBounds bounds(2);
  for (unsigned i = 0; i < 2; ++i) {
    bounds.setLow(i, space.lowest()[i]);
    bounds.setHigh(i, space.highest()[i]);
  }
  return bounds;
}

ob::SpaceInformationPtr PlaneOfDisc(const FreeSpace& space, double radius, std::uint64_t seed) {
  const auto plane = std::make_shared<ob::RealVectorStateSpace>(2);
  plane->setBounds(BoundsOf(space));
  plane->setStateSamplerAllocator(
      [seed, made = std::make_shared<int>(0)](const ob::StateSpace* state_space) {
        return std::make_shared<PlaneSampler>(state_space,
                                              NamedStream(seed, fmt::format("ompl/plane/{}", (*made)++)));
      });
  auto info = std::make_shared<ob::SpaceInformation>(plane);
  info->setStateValidityChecker(std::make_shared<DiscChecker>(info, space, radius));
  info->setMotionValidator(std::make_shared<DiscMotions>(info, space, radius));
  info->setup();
  return info;
}

Eigen::Vector2d PlaceOf(const ob::State* state) {
  const auto& place = *state->as<PlaneState>();
  return {place[0], place[1]};
}

}  // namespace ariadne::planning::internal
