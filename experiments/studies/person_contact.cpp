#include "experiments/studies/person_contact.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "drivers/simulated/ais_scanner.h"
#include "drivers/simulated/obstacles.h"
#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

using drivers::TruePose;
using slam::Pose2;

constexpr double kLookOn = 0.5;     // after a contact, whether it would have come all the same [s]
constexpr double kHalfWidth = 0.3;  // of the robot [m]
constexpr double kMoment = 0.02, kSpan = 0.1;  // [s]

/// The way of a robot, and how it brakes.
class Way {
 public:
  Way(const std::vector<TruePose>& path, const control::AvoidanceOptions& avoid)
      : path_(path), avoid_(avoid) {}

  TruePose At(double time) const {
    const auto later = std::ranges::upper_bound(path_, time, {}, &TruePose::time);
    return later == path_.begin() ? path_.front() : *(later - 1);
  }

  /// From full braking to standing, at the speed that it has at a time [s].
  double BrakingTime(double time) const {
    const Pose2 moved = MovedBefore(time);
    return std::max(moved.translation.norm() / avoid_.limits.acceleration,
                    std::abs(moved.angle) / avoid_.limits.turning_acceleration) /
           kSpan;
  }

  /// Whether it moved until then, however little.
  bool Moves(double time) const {
    const Pose2 moved = MovedBefore(time);
    return moved.translation.norm() + kHalfWidth * std::abs(moved.angle) > avoid_.creep * kSpan;
  }

  /// The last moment in which braking, after the reaction, lets the robot stand at a time [s].
  double LatestBraking(double standing) const {
    double time = standing - avoid_.reaction;
    while (time > 0.0 && time + avoid_.reaction + BrakingTime(time) > standing) time -= kMoment;
    return time;
  }

 private:
  Pose2 MovedBefore(double time) const {
    return At(time - kSpan).T_map_base.Inverse() * At(time).T_map_base;
  }

  const std::vector<TruePose>& path_;
  const control::AvoidanceOptions& avoid_;
};

const drivers::Body& BodyOf(const drivers::Collision& contact, const drivers::World& world) {
  const auto body = std::ranges::find(world.bodies, contact.thing, &drivers::Body::name);
  if (body == world.bodies.end()) Fail("{}: there is no {} to touch", world.name, contact.thing);
  return *body;
}

/// Until then.
bool Walks(const drivers::Body& body, double time, double slowest) {
  const auto place = [&](double at) { return drivers::PoseAt(body.motion, at).translation; };
  return !body.motion.times.empty() && (place(time) - place(time - kSpan)).norm() > slowest * kSpan;
}

/// Whether a robot that stands there would be touched until some time after a contact.
bool IsTouchedAt(const TruePose& stopped, double contact_time, const drivers::World& world) {
  const drivers::Obstacles obstacles(world, {});
  for (double time = stopped.time; time < contact_time + kLookOn; time += kMoment) {
    if (obstacles.ContactAt(stopped.T_map_base, time).depth > 0.0) return true;
  }
  return false;
}

}  // namespace

bool HasInView(const drivers::RayScene& scene, const Pose2& T_map_base, double time,
               const std::string& body, const drivers::SimulatedRobotOptions& robot) {
  constexpr int kBeams = 360;
  std::vector<slam::Pose3> T_base_scanners{drivers::AisMounting(robot.ais).T_base_laser};
  if (robot.safety.installed) {
    T_base_scanners.push_back(slam::ToPose3(Pose2{0.0, {robot.safety.front_x, 0.0}}));
    T_base_scanners.push_back(slam::ToPose3(Pose2{std::numbers::pi, {robot.safety.rear_x, 0.0}}));
    for (auto scanner = T_base_scanners.begin() + 1; scanner != T_base_scanners.end(); ++scanner)
      scanner->translation.z() = robot.safety.height;
  }
  for (const slam::Pose3& T_base_scanner : T_base_scanners) {
    const slam::Pose3 T_map_scanner = slam::ToPose3(T_map_base) * T_base_scanner;
    for (int i = 0; i <= kBeams; ++i) {
      const double bearing = (static_cast<double>(i) / kBeams - 0.5) * std::numbers::pi;
      const Eigen::Vector3d beam(std::cos(bearing), std::sin(bearing), 0.0);
      const drivers::Hit hit = scene.Cast({T_map_scanner.translation, T_map_scanner.rotation * beam, time});
      if (hit.hit() && scene.world().bodies[hit.body].name == body) return true;
    }
  }
  return false;
}

ContactVerdict JudgeContact(const drivers::Collision& contact, const std::vector<TruePose>& path_true,
                            const drivers::RayScene& scene, const drivers::SimulatedRobotOptions& robot,
                            const DriveOptions& drive) {
  const Way way(path_true, drive.avoid);
  const double reacted = contact.time - drive.avoid.reaction;
  // The way of a braking robot is half of what it would have driven in that time.
  const TruePose stopped = way.At(reacted - 0.5 * way.BrakingTime(reacted));
  ContactVerdict verdict;
  verdict.needless = !IsTouchedAt(stopped, contact.time, scene.world());
  const double latest = way.LatestBraking(contact.time), believed = latest - drive.moving.least;
  const auto in_view = [&](double time) {
    return HasInView(scene, way.At(time).T_map_base, time, contact.thing, robot);
  };
  verdict.foreseeable = way.Moves(contact.time) && in_view(latest) && in_view(believed) &&
                        Walks(BodyOf(contact, scene.world()), believed, drive.moving.slowest);
  return verdict;
}

}  // namespace ariadne::experiments
