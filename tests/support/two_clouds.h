#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "slam/geometry/angles.h"
#include "slam/geometry/box3.h"
#include "slam/scan/point_cloud.h"
#include "tests/support/random_room.h"

namespace ariadne::slam {

struct TwoCloudsSettings {
  std::size_t points = 5000;       // of each cloud
  double overlap = 0.6;            // share of the data that has a counterpart in the model
  double sigma = 0.01;             // of each coordinate, in both clouds [m]
  double outliers = 0.2;           // share of the points that are anywhere, in both clouds
  double start_translation = 1.0;  // largest error of the guess, at the centroid of the data [m]
  double start_angle = 15.0;       // [deg]
  double frame_translation = 1.0;  // how far the frames are from the room's [m]
};

/// Two samplings of one random room (no point twice), each in a frame of its own.
struct TwoClouds {
  PointCloud model;
  PointCloud data;
  Pose3 T_model_data;  // the truth
  Pose3 T_model_data_guess;
};

/// Moves each point by noise, and some anywhere in the box around all.
inline void Disturb(RandomStream& stream, const TwoCloudsSettings& settings, PointCloud& cloud) {
  const Box3 box = BoxAround(cloud.positions);
  for (Eigen::Vector3d& p : cloud.positions) {
    const bool outlier = DrawUniform(stream, 0.0, 1.0) < settings.outliers;
    p = outlier ? DrawInBox(stream, box.min(), box.max())
                : Eigen::Vector3d(p + DrawNoise(stream, settings.sigma));
  }
}

/// The model ends at a vertical plane in a random direction, beyond which lies the data's share without a
/// counterpart. Both were seen from the same six places, so that the rest sees the same surfaces.
inline TwoClouds DrawTwoClouds(std::uint64_t seed, const TwoCloudsSettings& settings = {}) {
  RandomStream stream = NamedStream(seed, "two_clouds");
  const Room room = DrawRoom(stream);
  std::vector<Eigen::Vector3d> viewpoints(6);
  for (Eigen::Vector3d& viewpoint : viewpoints) viewpoint = DrawViewpoint(stream, room);
  const double heading = DrawUniform(stream, 0.0, 2.0 * std::numbers::pi);
  const Eigen::Vector3d across(std::cos(heading), std::sin(heading), 0.0);

  TwoClouds clouds;
  clouds.data.positions = SampleSurfaces(stream, room, viewpoints, settings.points);
  std::vector<double> depths;
  for (const Eigen::Vector3d& p : clouds.data.positions) depths.push_back(across.dot(p));
  std::ranges::sort(depths);
  const auto last = static_cast<double>(depths.size() - 1);
  const double end = depths[static_cast<std::size_t>(settings.overlap * last)];
  while (clouds.model.size() < settings.points) {
    const Eigen::Vector3d p = SampleSurfaces(stream, room, viewpoints, 1).front();
    if (across.dot(p) <= end) clouds.model.positions.push_back(p);
  }
  Disturb(stream, settings, clouds.model);
  Disturb(stream, settings, clouds.data);

  const Pose3 T_room_model = DrawMotion(stream, settings.frame_translation, 1.0);
  const Pose3 T_room_data = DrawMotion(stream, settings.frame_translation, 1.0);
  clouds.model = Transformed(T_room_model.Inverse(), clouds.model);
  clouds.data = Transformed(T_room_data.Inverse(), clouds.data);
  clouds.T_model_data = T_room_model.Inverse() * T_room_data;
  const Pose3 error = DrawMotion(stream, settings.start_translation, RadFromDeg(settings.start_angle));
  clouds.T_model_data_guess = clouds.T_model_data * AboutPoint(CentroidOf(clouds.data.positions), error);
  return clouds;
}

}  // namespace ariadne::slam
