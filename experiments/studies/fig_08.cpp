#include "experiments/studies/fig_08.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "experiments/render/annotations.h"
#include "experiments/render/png_file.h"
#include "experiments/render/scales.h"
#include "experiments/run/manifest.h"
#include "experiments/run/run_page.h"
#include "experiments/studies/fig_08_drawing.h"
#include "slam/base/error.h"
#include "slam/geometry/angles.h"

namespace ariadne::experiments {
namespace {

using slam::Pose2;

constexpr Rgb kFrameInk{40, 44, 52};
constexpr Rgb kHelpInk{150, 156, 166};
constexpr Rgb kPathInk{46, 118, 190};
constexpr Rgb kBodyInk{20, 128, 84};
constexpr Rgb kLineOfSightInk{150, 60, 170};
constexpr Rgb kPhiInk{176, 112, 40};
constexpr Rgb kAlphaInk{214, 64, 40};

/// Of the controller, at one moment.
struct ControlState {
  Pose2 T_goal_robot;
  control::GoalBearing bearing;
  double curvature = 0.0;  // c [1/m]
  control::DriveCommand command;
  control::ApproachResult path;
};

ControlState StateOf(const Fig08Options& options) {
  ControlState state;
  state.T_goal_robot = {slam::RadFromDeg(options.heading), {options.x, options.y}};
  state.bearing = control::BearingOf(state.T_goal_robot);
  state.curvature = control::PathCurvature(state.bearing, options.approach.law);
  state.command = control::Saturated(control::SteerToGoal(state.T_goal_robot, options.approach.law),
                                     options.approach.limits);
  state.path = SimulateApproach(state.T_goal_robot, {}, options.approach);
  return state;
}

Eigen::Vector2d Towards(double direction) { return {std::cos(direction), std::sin(direction)}; }

/// Everything that is to be in the picture.
Polyline ExtentOf(const ControlState& state) {
  const double e = state.bearing.distance;
  const Eigen::Vector2d& robot = state.T_goal_robot.translation;
  Polyline places{{0.3 * e, 0.0}, {0.0, 0.25 * e}};
  for (const double x : {-0.5, 0.5}) {
    for (const double y : {-0.5, 0.5}) places.push_back(robot + 1.4 * Eigen::Vector2d(x, y));
  }
  for (const control::ApproachSample& sample : state.path.samples)
    places.push_back(sample.T_map_robot.translation);
  return places;
}

/// The goal's frame, and where the robot is in it.
void DrawGoalFrame(FrameCanvas& canvas, const ControlState& state) {
  const double e = state.bearing.distance;
  const Eigen::Vector2d& robot = state.T_goal_robot.translation;
  const Eigen::Vector2d on_x(robot.x(), 0.0), on_y(0.0, robot.y());
  const double gap = 0.03 * e;
  canvas.Line({on_x, {0.0, 0.0}}, kHelpInk);
  canvas.Line({on_y, {0.0, 0.0}}, kHelpInk);
  canvas.DashedLine(robot, on_x, kHelpInk);
  canvas.DashedLine(robot, on_y, kHelpInk);
  canvas.Text(on_x + Eigen::Vector2d(0.0, std::copysign(gap, -robot.y())), "xG", kFrameInk);
  canvas.Text(on_y + Eigen::Vector2d(std::copysign(1.5 * gap, -robot.x()), 0.0), "yG", kFrameInk);
  canvas.Arrow({0.0, 0.0}, {0.25 * e, 0.0}, kFrameInk, 1.6);
  canvas.Arrow({0.0, 0.0}, {0.0, 0.25 * e}, kFrameInk, 1.6);
  canvas.Text({0.25 * e, gap}, "x", kFrameInk);
  canvas.Text({gap, 0.25 * e}, "y", kFrameInk);
  canvas.Dot({0.0, 0.0}, kFrameInk, 1.6);
  canvas.Text({0.13 * e, -gap}, "goal (0, 0, 0)", kFrameInk, 0.8);
}

/// An angle at the robot with its letter in the middle of the arc, just outside.
void DrawAngle(FrameCanvas& canvas, const Eigen::Vector2d& at, double radius, double from, double to,
               std::string_view letter, Rgb ink) {
  canvas.Arc(at, radius, from, to, ink, 1.3);
  const double outside = radius + 14.0 * canvas.Pen();
  canvas.Text(at + outside * Towards(0.5 * (from + to)), letter, ink);
}

void DrawRobotAndAngles(FrameCanvas& canvas, const ControlState& state, const Fig08Options& options) {
  const Pose2& pose = state.T_goal_robot;
  const Eigen::Vector2d& at = pose.translation;
  const double e = state.bearing.distance, theta = state.bearing.theta;
  const double phi = pose.angle;
  canvas.Robot(pose, options.robot.length, options.robot.width, options.approach.limits.track, kBodyInk);
  canvas.DashedLine(at, at + 0.62 * e * Eigen::Vector2d::UnitX(), kHelpInk);
  canvas.Line({at, {0.0, 0.0}}, kLineOfSightInk, 1.3);
  const Eigen::Vector2d left(-std::sin(theta), std::cos(theta));
  canvas.Text(0.42 * at + 0.03 * e * left, "e", kLineOfSightInk);
  canvas.Arrow(at, at + 0.42 * e * Towards(phi), kBodyInk, 1.8);
  canvas.Text(at + 0.45 * e * Towards(phi), "u", kBodyInk);
  canvas.Arrow(at, at + 0.16 * e * Towards(phi + 0.5 * std::numbers::pi), kBodyInk, 1.2);
  DrawAngle(canvas, at, 0.26 * e, 0.0, phi, "\u03c6", kPhiInk);
  DrawAngle(canvas, at, 0.31 * e, phi, phi + state.bearing.alpha, "\u03b1", kAlphaInk);
  DrawAngle(canvas, at, 0.53 * e, 0.0, theta, "\u03b8", kLineOfSightInk);
  const double turn = std::copysign(1.0, state.command.turning);
  const double behind = phi + std::numbers::pi;
  DrawAngle(canvas, at, 0.15 * e, behind - 0.5 * turn, behind + 0.5 * turn, "\u03c9", kBodyInk);
  canvas.Dot(at, kBodyInk, 1.4);
}

Image FramesPicture(const ControlState& state, const Fig08Options& options) {
  FrameCanvas canvas(ExtentOf(state), options.width);
  DrawGoalFrame(canvas, state);
  Polyline way;
  for (const control::ApproachSample& sample : state.path.samples)
    way.push_back(sample.T_map_robot.translation);
  canvas.Line(way, kPathInk, 1.8);
  DrawRobotAndAngles(canvas, state, options);
  const Image picture = WithScaleBar(canvas.image(), canvas.camera());
  const std::string numbers = fmt::format(
      "e = {:.2f} m, \u03b8 = {:.1f} deg, \u03b1 = {:.1f} deg: c = {:.2f} / m, u = {:.2f} m/s, \u03c9 = u "
      "c = "
      "{:.2f} rad/s",
      state.bearing.distance, slam::DegFromRad(state.bearing.theta), slam::DegFromRad(state.bearing.alpha),
      state.curvature, state.command.forward, state.command.turning);
  return WithLegend(WithCaption(picture, numbers),
                    {{"robot, speeds u and \u03c9", kBodyInk},
                     {"e, \u03b8: to the goal, in its frame", kLineOfSightInk},
                     {"\u03c6: heading", kPhiInk},
                     {"\u03b1 = \u03b8 - \u03c6", kAlphaInk},
                     {"path of the controller", kPathInk}});
}

Json NumbersOf(const ControlState& state) {
  return {{"x_m", state.T_goal_robot.translation.x()},
          {"y_m", state.T_goal_robot.translation.y()},
          {"phi_deg", slam::DegFromRad(state.T_goal_robot.angle)},
          {"e_m", state.bearing.distance},
          {"theta_deg", slam::DegFromRad(state.bearing.theta)},
          {"alpha_deg", slam::DegFromRad(state.bearing.alpha)},
          {"curvature_per_m", state.curvature},
          {"forward_m_per_s", state.command.forward},
          {"turning_rad_per_s", state.command.turning},
          {"path_m", state.path.length}};
}

}  // namespace

void CheckFig08(const Fig08Options& options) {
  control::RequireGains(options.approach.law);
  if (std::hypot(options.x, options.y) < options.approach.goal_distance)
    Fail("x, y: ({}, {}) m is the goal itself, where the control law has no angles", options.x, options.y);
}

std::string RunFig08(const Fig08Options& options, const RunDirectory& run, ProgressDisplay&) {
  CheckFig08(options);
  WriteManifest(run, {});
  const ControlState state = StateOf(options);
  WritePng(run.File("figures/fig_08.png"), FramesPicture(state, options));
  const Json numbers = NumbersOf(state);
  run.WriteJson("metrics.json", numbers);
  FinishRun(run, "Fig. 8: frames and quantities of the control law", 1);
  return fmt::format(
      "e = {:.2f} m, theta = {:.1f} deg, alpha = {:.1f} deg, phi = {:.1f} deg: c = {:.3f} 1/m, "
      "u = {:.2f} m/s, omega = {:.3f} rad/s\n",
      state.bearing.distance, numbers["theta_deg"].get<double>(), numbers["alpha_deg"].get<double>(),
      numbers["phi_deg"].get<double>(), state.curvature, state.command.forward, state.command.turning);
}

}  // namespace ariadne::experiments
