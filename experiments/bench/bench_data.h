#pragma once

#include <string>

#include "slam/scan/point_cloud.h"

namespace ariadne::bench {

/// The two clouds on which registration is measured: the first pair of the real hallway, or of the built-in
/// office where the data are missing.
struct BenchPair {
  std::string name;
  slam::PointCloud model;  // all points between 0.5 and 32 m
  slam::PointCloud data;
  slam::PointCloud model_reduced;  // octree centers, cells as 3DTK's -r 10
  slam::PointCloud data_reduced;
  slam::Pose3 T_model_data_guess;
};

/// Read once; every benchmark gets the same.
const BenchPair& Pair();

/// Gate and stop rule of all measurements.
inline constexpr double kMaxDistance = 0.5;      // [m]
inline constexpr double kConvergenceRms = 1e-7;  // [m]
/// Iterations that these take, for peers with other stop rules: 44 on the hallway.
int Iterations(bool reduced);

}  // namespace ariadne::bench
