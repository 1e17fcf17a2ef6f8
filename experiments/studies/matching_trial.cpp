#include "experiments/studies/matching_trial.h"

#include <Eigen/Cholesky>

#include "experiments/metrics/map_error.h"
#include "experiments/metrics/trajectory_error.h"
#include "experiments/metrics/wall_thickness.h"
#include "slam/base/stopwatch.h"
#include "slam/graph/optimize/covariance.h"

namespace ariadne::experiments {
namespace {

constexpr std::size_t kThinning = 7;  // of a scan's points for metrics; not a divisor of 181, so no stripes
constexpr double kScannerGate =
    0.06;  // between a beam's end and the wall that it has met: bias and noise [m]

slam::PointCloud Thinned(const slam::PointCloud& cloud) {
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < cloud.size(); i += kThinning) indices.push_back(i);
  return slam::Selected(cloud, indices);
}

/// The thinned points of all scans at the given poses.
std::vector<Eigen::Vector3d> Gather(const TourScans& scans, const std::vector<slam::Pose3>& T_world_laser) {
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i < scans.thinned_laser.size(); ++i) {
    for (const Eigen::Vector3d& p_laser : scans.thinned_laser[i].positions) {
      points.push_back(T_world_laser[i] * p_laser);
    }
  }
  return points;
}

/// The mean over all scans but the master of e^T C^-1 e, where e is the error of the position relative to
/// the master, in the frame of the laser, and C its covariance by the graph.
double MeanPositionNees(const slam::Mapper& mapper, const TourScans& scans) {
  const slam::PoseGraph3& graph = mapper.graph().graph;
  const std::vector<slam::Pose3::Square> covariances = slam::MarginalCovariances(graph).nodes;
  const slam::Pose3 T_world_map =
      PlaceByMaster(mapper.scans().front().T_map_laser, scans.T_map_laser_true.front());
  double sum = 0.0;
  for (std::size_t i = 1; i < covariances.size(); ++i) {
    const slam::Pose3 T_world_laser = T_world_map * mapper.scans()[i].T_map_laser;
    const Eigen::Vector3d e = (T_world_laser.Inverse() * scans.T_map_laser_true[i]).translation;
    const Eigen::Matrix3d C = covariances[i].topLeftCorner<3, 3>();
    sum += e.dot(C.ldlt().solve(e));
  }
  return sum / static_cast<double>(covariances.size() - 1);
}

}  // namespace

TrueBuilding::TrueBuilding(const drivers::World& world)
    : surface(world), walls(FindWallFaces(world, WallFaceOptions{})) {}

TourScans TakeTourScans(const SimulatedTour& tour, const TrueBuilding& building, const Parallel& parallel) {
  TourScans scans;
  for (std::size_t i = 0; i < tour.size(); ++i) {
    slam::PointCloud cloud = slam::ToPointCloud(tour.TakeScan(i, parallel));
    scans.thinned_laser.push_back(Thinned(cloud));
    scans.scans.push_back({"scan", std::move(cloud), tour.T_odom_laser(i)});
    scans.T_map_laser_true.push_back(tour.T_map_laser_true(i));
  }
  scans.wall_of_point = AssignToWalls(Gather(scans, scans.T_map_laser_true), building.walls,
                                      building.surface, kScannerGate, parallel);
  return scans;
}

MatchingTrial JudgePoses(const TourScans& scans, const TrueBuilding& building,
                         std::vector<slam::Pose3> T_map_laser, const Parallel& parallel) {
  MatchingTrial trial;
  const slam::Pose3 T_world_map = PlaceByMaster(T_map_laser.front(), scans.T_map_laser_true.front());
  const TrajectoryError error = ErrorFromMaster(T_map_laser, scans.T_map_laser_true);
  trial.translation_rms = error.translation.rms;
  trial.rotation_rms = error.rotation.rms;

  std::vector<slam::Pose3> T_world_laser;
  for (const slam::Pose3& pose : T_map_laser) T_world_laser.push_back(T_world_map * pose);
  const std::vector<Eigen::Vector3d> points_world = Gather(scans, T_world_laser);
  const MapError map = MeasureMapError(points_world, {}, building.surface, MapErrorOptions{}, parallel);
  trial.map_error_mean = map.mean;
  trial.map_error_95 = map.percentile_95;
  trial.share_within_2cm = map.share_within;
  const WallThicknessSummary walls =
      MeasureWallThickness(points_world, scans.wall_of_point, building.walls, WallThicknessOptions{});
  trial.wall_median = walls.median_standard_deviation;
  trial.wall_worst = walls.worst_standard_deviation;
  trial.T_map_laser = std::move(T_map_laser);
  return trial;
}

MatchingTrial TryMatching(const TourScans& scans, const TrueBuilding& building,
                          const slam::MapperOptions& options, const Parallel& parallel) {
  const Stopwatch watch;
  slam::Mapper mapper(options);
  std::size_t registered = 0;
  for (const slam::PosedCloud& scan : scans.scans) registered += mapper.AddScan(scan).registered ? 1 : 0;
  mapper.Finish();
  const double seconds = watch.Seconds();
  std::vector<slam::Pose3> T_map_laser;
  for (const slam::MapScan& scan : mapper.scans()) T_map_laser.push_back(scan.T_map_laser);
  MatchingTrial trial = JudgePoses(scans, building, std::move(T_map_laser), parallel);
  trial.registered = registered;
  trial.seconds = seconds;
  if (options.registration.method == slam::MatchMethod::kGraph && mapper.scans().size() > 1)
    trial.nees = MeanPositionNees(mapper, scans);
  return trial;
}

}  // namespace ariadne::experiments
