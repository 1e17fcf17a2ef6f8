#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "planning/polygon/labelled_polygon.h"
#include "slam/geometry/box3.h"
#include "slam/geometry/pose3.h"
#include "slam/geometry/triangle_mesh.h"
#include "slam/scan/point_cloud.h"

namespace ariadne::experiments {

// What the interactive view of a page shows, all in the frame of the map [m]. Everything has a step: the
// slider of the page shows what was known up to a step of the run. Steps count from 0.

/// Where a scan was taken.
struct ViewerStop {
  std::string name;
  slam::Pose3 T_map_laser;
  std::size_t step = 0;
};

/// A point of a scan.
struct ViewerPoint {
  Eigen::Vector3f p_map = Eigen::Vector3f::Zero();
  float reflectance = 0.0F;  // the unit is the device's
  std::uint32_t stop = 0;    // its scan: an index of ViewerScene::stops
};

/// A box along the axes of a frame of its own; that of SegmentObjects lies along the axes of the map.
struct ViewerBox {
  slam::Box3 box;
  slam::Pose3 T_map_box = {};
  std::size_t step = 0;
};

/// A way, driven or planned.
struct ViewerPath {
  std::vector<Eigen::Vector3d> points_map;
  std::size_t step = 0;
};

/// What is known to be free at a height, with the edges that are seen and those that are not.
struct ViewerPolygon {
  planning::LabelledPolygon polygon_map;
  double z_map = 0.0;
  std::size_t step = 0;
};

/// Any part may be empty.
struct ViewerScene {
  std::vector<ViewerStop> stops;
  std::vector<ViewerPoint> points;
  bool has_reflectance = false;
  std::vector<ViewerBox> boxes;
  std::vector<ViewerPath> driven;       // shown up to the step of the slider
  std::vector<ViewerPath> planned;      // the latest alone
  std::vector<ViewerPolygon> polygons;  // the latest alone
  slam::TriangleMesh mesh_map = {};     // of the end, with its colours or none
};

/// Adds a scan: its pose as a stop, and its points. Reflectance counts where all scans have it.
void AddScan(ViewerScene& scene, const slam::PosedCloud& scan, std::size_t step);

/// Scans one after another, one per step, with the straight ways between them as the path.
ViewerScene SceneOf(std::span<const slam::PosedCloud> scans);

}  // namespace ariadne::experiments
