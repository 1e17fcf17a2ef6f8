#pragma once

#include "drivers/simulated/surface_distance.h"
#include "experiments/metrics/wall_faces.h"
#include "experiments/run/run_directory.h"
#include "experiments/run/scan_source.h"
#include "slam/mapper.h"

namespace ariadne::experiments {

/// The true building, as metrics need it; made once per world.
struct TrueBuilding {
  drivers::SurfaceDistance surface;
  WallFaces walls;

  explicit TrueBuilding(const drivers::World& world);
};

/// All scans of a tour, as the methods get them, and as the metrics look at the outcome.
struct TourScans {
  std::vector<slam::PosedCloud> scans;  // at their poses by odometry
  std::vector<slam::Pose3> T_map_laser_true;
  std::vector<slam::PointCloud> thinned_laser;  // for metrics and pictures
  std::vector<std::uint32_t> wall_of_point;     // of the thinned points of all scans, by their true place
};

/// Casts the scans of the tour.
TourScans TakeTourScans(const SimulatedTour& tour, const TrueBuilding& building, const Parallel& parallel);

/// The outcome of one way of matching.
struct MatchingTrial {
  std::vector<slam::Pose3> T_map_laser;
  std::size_t registered = 0;
  double translation_rms = 0.0;  // from the master (ErrorFromMaster) [m]
  double rotation_rms = 0.0;     // [rad]
  double map_error_mean = 0.0;   // MeasureMapError [m]
  double map_error_95 = 0.0;     // [m]
  double share_within_2cm = 0.0;
  double wall_median = 0.0;  // standard deviation across the median wall [m]
  double wall_worst = 0.0;   // and across the worst [m]
  double nees = 0.0;         // graph: mean normalized squared error of the positions, 3 if its covariances
                             // are honest
  double seconds = 0.0;      // of matching alone
};

/// Judges poses of the scans, however they were found.
MatchingTrial JudgePoses(const TourScans& scans, const TrueBuilding& building,
                         std::vector<slam::Pose3> T_map_laser, const Parallel& parallel);

/// Registers the scans with the mapper and judges the map.
MatchingTrial TryMatching(const TourScans& scans, const TrueBuilding& building,
                          const slam::MapperOptions& options, const Parallel& parallel);

}  // namespace ariadne::experiments
