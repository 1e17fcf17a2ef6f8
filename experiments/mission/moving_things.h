#pragma once

#include <Eigen/Core>
#include <deque>
#include <functional>
#include <span>
#include <vector>

#include "slam/base/options.h"

namespace ariadne::experiments {

struct MovingThingsOptions {
  bool watch = true;
  double slowest = 0.3;
  double way = 0.2;
  double off_line = 0.08;
  double largest = 0.8;
  double gap = 0.2;
  double jump = 0.25;
  double memory = 0.5;
  double least = 0.25;
  double body = 0.4;
  double unseen = 0.8;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("watch", self.watch, "stop for where what moves will be, not only for where it is (5.3)");
    visit("slowest", self.slowest, Unit("m/s"), Range{0.01, 10.0},
          "that counts as moving: the middle of what stands shifts when it is seen from elsewhere");
    visit("way", self.way, Unit("m"), Range{0.0, 10.0}, "that it has moved before it is believed");
    visit("off_line", self.off_line, Unit("m"), Range{0.001, 10.0},
          "that it strays from an even way, rms: what is seen of a plant jumps to and fro");
    visit("largest", self.largest, Unit("m"), Range{0.05, 10.0}, "that is watched: larger things stand");
    visit("gap", self.gap, Unit("m"), Range{0.01, 10.0}, "between the points of two things");
    visit("jump", self.jump, Unit("m"), Range{0.01, 10.0},
          "from sweep to sweep, beyond which it is another thing");
    visit("memory", self.memory, Unit("s"), Range{0.05, 10.0}, "of which the speed is the mean");
    visit("least", self.least, Unit("s"), Range{0.05, 10.0},
          "that a thing is watched before it is believed");
    visit("body", self.body, Unit("m"), Range{0.0, 2.0},
          "around a leg that has walked, that the robot keeps off: arms and hips are wider than what the "
          "scanners see of a person");
    visit("unseen", self.unseen, Unit("s"), Range{0.0, 10.0},
          "that what walks is taken to walk on: there is a strip on each side of the robot into which no "
          "scanner looks");
  }
};

/// What moves around a robot, such as a person's legs: runs of points of a sweep that are followed from
/// sweep to sweep. Those that something nearer hides at one end are not: what is seen of a wall past a
/// pillar moves as the robot does.
class MovingThings {
 public:
  explicit MovingThings(const MovingThingsOptions& options = {}) : options_(options) {}

  /// The points of one look around from a place, each scanner's in the order of its beams, in a frame that
  /// stands [m], at a time [s].
  void Update(std::span<const Eigen::Vector2d> points_odom, const Eigen::Vector2d& viewpoint_odom,
              double time);

  /// Where what has moved is and will be, as long as it goes on as it does, until so much later [s]; points
  /// around it. What is where something `stands`, as far as is known, has not moved.
  std::vector<Eigen::Vector2d> PlacesUntil(
      double later, const std::function<bool(const Eigen::Vector2d& p_odom)>& stands = {}) const;

 private:
  struct Seen {
    double time;
    Eigen::Vector2d middle_odom;
  };
  /// One thing, as long as it is seen.
  struct Track {
    std::deque<Seen> seen;
    bool has_moved = false;
  };

  std::vector<Eigen::Vector2d> MiddlesOf(std::span<const Eigen::Vector2d> points_odom,
                                         const Eigen::Vector2d& viewpoint_odom) const;
  Eigen::Vector2d VelocityOf(const Track& track) const;
  bool Walks(const Track& track) const;
  bool IsBesideWalker(const Eigen::Vector2d& middle_odom) const;
  bool WalksOnUnseen(const Track& track, double time) const;

  MovingThingsOptions options_;
  std::vector<Track> tracks_;
  double now_ = 0.0;  // [s]
};

}  // namespace ariadne::experiments
