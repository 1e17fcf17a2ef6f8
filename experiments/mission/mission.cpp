#include "experiments/mission/mission.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "drivers/emergency_stopped.h"
#include "experiments/mission/area_left.h"
#include "experiments/mission/way_back.h"
#include "slam/base/stopwatch.h"

namespace ariadne::experiments {
namespace {

using slam::Pose2;

constexpr double kSamePlaceAgain = 0.5;  // [m]
constexpr double kNotFar = 1.0;          // to and fro, between drives that are blocked [m]
constexpr double kAway = 3.0;            // from where nothing leads on [m]
constexpr double kPathStep = 0.05;       // of the path that is kept [m]

/// Where what the map knows has held the robot up, the map or the robot err by more than half the margin of
/// a path: one with half of it keeps the whole from there.
void AddRing(const Eigen::Vector2d& p_map, double radius, std::vector<Eigen::Vector2d>& places_map) {
  constexpr int kPlaces = 8;
  for (int k = 0; k < kPlaces; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / kPlaces;
    places_map.emplace_back(p_map + radius * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
}

/// A mission under way.
class Explorer {
 public:
  Explorer(drivers::Robot& robot, const MissionOptions& options, std::uint64_t seed,
           const MissionEvents& events)
      : robot_(robot),
        options_(options),
        seed_(seed),
        events_(events),
        map_(options, robot.T_base_laser()) {}

  MissionResult Run();

 private:
  MissionResult Explore();

  void Status(const std::string& text) const {
    if (events_.on_status) events_.on_status(text);
  }
  bool IsStopped() const { return events_.stop && events_.stop(); }

  void AcquireAndRegister();
  std::optional<PlannedDrive> Plan();
  std::optional<PlannedDrive> PlanView(Surroundings& around, const Pose2& T_map_base, std::uint64_t seed);
  bool MayGoBack() const { return options_.drive_by != DriveBy::kApproach; }  // the loop of 2003 never does
  void Drive(const PlannedDrive& drive);
  void ReturnToStart();
  std::optional<MissionEnd> Limit() const;
  MissionResult Finish(MissionEnd end);
  void NoteFailure(const PlannedDrive& drive, const DriveReport& report);

  drivers::Robot& robot_;
  const MissionOptions& options_;
  std::uint64_t seed_;
  const MissionEvents& events_;
  MissionMap map_;
  MissionStop next_;  // what is known of the stop to come
  slam::ScannerModel scanner_;
  Pose2 last_T_odom_base_;
  std::vector<Pose2> trail_map_;                   // driven, to where the robot is
  std::optional<Pose2::Square> guess_covariance_;  // of where it is, if the way there was sure
  MissionResult result_;
  std::vector<Eigen::Vector2d> obstacles_map_;  // as last known
  std::vector<Eigen::Vector2d> held_map_;       // of these, what has held the robot up
  std::vector<FailedTarget> failed_;
  bool went_out_ = false;                                  // since the last view that something led to
  int blocked_ = 0, unregistered_ = 0;                     // in a row
  Eigen::Vector2d blocked_map_ = Eigen::Vector2d::Zero();  // near which it was blocked so often
};

void Explorer::AcquireAndRegister() {
  Status(fmt::format("scan {}: taking it", map_.size()));
  const slam::Scan scan = robot_.TakeScan();
  Status(fmt::format("scan {}: registering it", map_.size()));
  const Stopwatch watch;
  scanner_ = scan.scanner;
  const Pose2 moved = last_T_odom_base_.Inverse() * scan.odometry.T_odom_base;  // while it braked
  const Pose2 T_map_base_guess = map_.size() == 0 ? scan.odometry.T_odom_base : trail_map_.back() * moved;
  const slam::MatchResult match = map_.AddScan(
      fmt::format("scan{:03}", map_.size()), slam::ToPointCloud(scan), T_map_base_guess, guess_covariance_);
  last_T_odom_base_ = scan.odometry.T_odom_base;
  MissionStop stop = std::move(next_);
  next_ = {};
  stop.matching_seconds = watch.Seconds();
  stop.time = robot_.Now();
  stop.distance = result_.distance;
  stop.registered = match.registered;
  stop.message = match.message;
  stop.T_map_base = map_.T_map_base(map_.size() - 1);
  stop.T_map_base_guess = FromAbove(match.T_map_laser_guess * robot_.T_base_laser().Inverse());
  trail_map_.push_back(stop.T_map_base);
  unregistered_ = match.registered ? 0 : unregistered_ + 1;
  const std::vector<planning::LabelledPolygon>& area = map_.Area(0);
  stop.unseen = UnseenLength(area);
  stop.free_area = FreeArea(area);
  stop.views_left = ViewsLeft(area, options_.planner.min_opening);
  result_.stops.push_back(stop);
  if (events_.on_stop) events_.on_stop(stop, map_);
}

std::optional<MissionEnd> Explorer::Limit() const {
  if (IsStopped()) return MissionEnd::kStopped;
  if (unregistered_ >= options_.patience.unregistered) return MissionEnd::kLost;
  if (blocked_ >= options_.patience.blocked) return MissionEnd::kStuck;
  if (map_.size() >= static_cast<std::size_t>(options_.limits.max_scans)) return MissionEnd::kScanLimit;
  if (robot_.Now() >= options_.limits.max_time) return MissionEnd::kTimeLimit;
  if (result_.distance >= options_.limits.max_distance) return MissionEnd::kDistanceLimit;
  return {};
}

/// To the next view, or back to where something leads to one; then to what is to be looked at more closely,
/// of which the areas around tell from then on.
std::optional<PlannedDrive> Explorer::PlanView(Surroundings& around, const Pose2& T_map_base,
                                               std::uint64_t seed) {
  std::optional<PlannedDrive> drive = PlanNextDrive(around, T_map_base, failed_, options_, seed);
  if (drive) {
    went_out_ = false;
  } else if (!went_out_ && MayGoBack()) {
    drive = PlanWayOut(around, failed_, options_, seed);
    went_out_ = drive.has_value();
  }
  if (drive || options_.area.sparse.max_spacing == 0.0) return drive;
  for (std::size_t h = 0; h < map_.height_count(); ++h) around.areas[h] = map_.AreaToLookCloser(h);
  return PlanNextDrive(around, T_map_base, failed_, options_, seed);
}

/// The next view; after a scan that was not registered, where the robot was sure before.
std::optional<PlannedDrive> Explorer::Plan() {
  Status(fmt::format("scan {}: planning", map_.size() - 1));
  const Stopwatch watch;
  Surroundings around = SurroundingsOf(map_, trail_map_);
  obstacles_map_ = around.obstacles_map;
  for (const Eigen::Vector2d& p_map : held_map_)
    AddRing(p_map, 0.5 * options_.path.footprint.margin, around.obstacles_map);
  const Pose2 T_map_base = map_.T_map_base(map_.size() - 1);
  const std::uint64_t seed = seed_ + map_.size();
  std::optional<PlannedDrive> drive;
  if (unregistered_ > 0) {
    std::size_t sure = map_.size() - 1;
    while (sure > 0 && !map_.registered(sure)) --sure;
    drive = PlanDriveTo(around, T_map_base, map_.T_map_base(sure), options_, seed);
  } else if (2 * blocked_ >= options_.patience.blocked && MayGoBack()) {
    drive = PlanRetreat(around.trail_map, kAway);
  } else {
    drive = PlanView(around, T_map_base, seed);
  }
  next_.planning_seconds = watch.Seconds();
  if (drive && events_.on_plan) events_.on_plan(*drive, around);
  return drive;
}

void Explorer::Drive(const PlannedDrive& drive) {
  Status(fmt::format(
      "scan {}: driving{}", map_.size() - 1,
      drive.view ? fmt::format(" to ({:.1f}, {:.1f}) m", drive.view->p_map.x(), drive.view->p_map.y())
                 : " back"));
  const Stopwatch watch;
  const Pose2 T_map_base = map_.T_map_base(map_.size() - 1);
  const LocalizerOptions& localize = options_.drive.localize;
  const std::optional<slam::AlignModel> model_map =
      localize.enabled ? map_.ModelAround(T_map_base.translation, localize.reach) : std::nullopt;
  const Localizer localizer(robot_, T_map_base, model_map ? &*model_map : nullptr, scanner_, localize);
  const DriveReport report =
      DrivePath(robot_, localizer,
                {drive.path_map, drive.approach, trail_map_, obstacles_map_, drive.margin, drive.retraced},
                options_.drive, events_.stop);
  last_T_odom_base_ = robot_.State().odometry.T_odom_base;
  guess_covariance_.reset();
  if (unregistered_ == 0) guess_covariance_ = report.covariance;  // else it is not known where it has left
  AddToTrail(report.poses_map, trail_map_);
  for (const Eigen::Vector2d& p_map : report.obstacles_map) map_.AddObstacle(p_map);
  if (report.held_map) held_map_.push_back(*report.held_map);
  for (const Pose2& pose : report.poses_map) {
    if (result_.path_map.empty() || (pose.translation - result_.path_map.back()).norm() > kPathStep)
      result_.path_map.push_back(pose.translation);
  }
  result_.distance += report.length;
  next_.driving_seconds = watch.Seconds();
  next_.view = drive.view;
  next_.drive = report.end;
  next_.reason = report.reason;
  next_.leg_only = drive.leg_only;
  next_.of_disc = drive.of_disc;
  next_.driven_map = report.poses_map;
  if (report.end == DriveEnd::kBlocked) {
    NoteFailure(drive, report);
  } else {
    blocked_ = 0;
  }
}

void Explorer::NoteFailure(const PlannedDrive& drive, const DriveReport& report) {
  const Eigen::Vector2d& p_map = report.poses_map.back().translation;
  if (blocked_ == 0 || (p_map - blocked_map_).norm() > kNotFar) blocked_ = 0, blocked_map_ = p_map;
  ++blocked_;
  if (!drive.view) return;
  const auto known = std::ranges::find_if(failed_, [&](const FailedTarget& target) {
    return target.of_disc == drive.of_disc && (target.p_map - drive.view->p_map).norm() < kSamePlaceAgain;
  });
  FailedTarget& target = known == failed_.end()
                             ? failed_.emplace_back(FailedTarget{drive.view->p_map, 0, drive.of_disc})
                             : *known;
  target.times += 1;
}

void Explorer::ReturnToStart() {
  constexpr int kTries = 100;
  for (int i = 0; i < kTries && !Limit(); ++i) {
    const Pose2 T_map_base = map_.T_map_base(map_.size() - 1);
    const Pose2 T_map_start = map_.T_map_base(0);
    if ((T_map_base.translation - T_map_start.translation).norm() < kSamePlaceAgain) {
      result_.returned = true;
      return;
    }
    const auto drive = PlanDriveTo(SurroundingsOf(map_, trail_map_), T_map_base, T_map_start, options_,
                                   seed_ + map_.size());
    if (!drive) return;
    Drive(*drive);
    AcquireAndRegister();
  }
}

MissionResult Explorer::Finish(MissionEnd end) {
  Status("integrating all scans");
  map_.Finish();
  result_.end = end;
  result_.scans = map_.Scans();
  for (std::size_t i = 0; i < map_.size(); ++i) result_.registered.push_back(map_.registered(i));
  result_.area = map_.Area(0);
  result_.obstacles_map = map_.LookAtGround().obstacles_map;
  result_.time = robot_.Now();
  return std::move(result_);
}

/// A robot that was told to stop may know so before it is asked here, and refuses what it is then told.
MissionResult Explorer::Run() {
  try {
    return Explore();
  } catch (const drivers::EmergencyStopped&) {
    if (map_.size() == 0 || !IsStopped()) throw;
    return Finish(MissionEnd::kStopped);
  }
}

MissionResult Explorer::Explore() {
  AcquireAndRegister();
  for (;;) {
    if (const std::optional<MissionEnd> limit = Limit()) return Finish(*limit);
    const std::optional<PlannedDrive> drive = Plan();
    if (!drive) {
      if (unregistered_ > 0) return Finish(MissionEnd::kLost);
      if (options_.return_to_start) ReturnToStart();
      return Finish(MissionEnd::kNothingLeft);
    }
    if (events_.approve && !events_.approve(*drive)) return Finish(MissionEnd::kRejected);
    Drive(*drive);
    if (next_.drive == DriveEnd::kStopped) return Finish(MissionEnd::kStopped);
    AcquireAndRegister();
  }
}

}  // namespace

std::string_view Describe(MissionEnd end) {
  constexpr std::array<std::string_view, 8> kSentences{
      "nothing is left that is worth a scan and can be reached",
      "the limit of scans is reached",
      "the limit of time is reached",
      "the limit of distance is reached",
      "the robot is stuck: drive after drive ended at an obstacle",
      "the robot is lost: scan after scan could not be registered",
      "a plan was not approved",
      "it was stopped"};
  return kSentences[static_cast<std::size_t>(end)];
}

MissionResult RunMission(drivers::Robot& robot, const MissionOptions& options, std::uint64_t seed,
                         const MissionEvents& events) {
  CheckOptions(options, "mission.");
  return Explorer(robot, options, seed, events).Run();
}

}  // namespace ariadne::experiments
