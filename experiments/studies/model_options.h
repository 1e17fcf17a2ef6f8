#pragma once

#include <string>

#include "slam/io/octomap_file.h"
#include "slam/io/svg.h"
#include "slam/map/line_map.h"
#include "slam/map/occupancy_grid.h"
#include "slam/map/octree.h"
#include "slam/map/scan_mesh.h"
#include "slam/map/surface_model.h"

namespace ariadne::experiments {

/// How registered scans become a model of the building, in each of its forms.
struct ModelOptions {
  slam::SurfaceModelOptions surfaces;
  slam::OctreeOptions octree;
  slam::MeshOfScansOptions mesh;
  slam::LineMapOptions plan;
  std::string plan_heights = "0.5, 1.5";
  slam::OccupancyGridOptions grid;
  slam::OctoMapOptions octomap{.resolution = 0.1};
  slam::SvgOptions svg;
  double drawing_points = 0.1;
  int picture_width = 1600;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("surfaces", self.surfaces, "flat surfaces and boxes around objects");
    visit("octree", self.octree, "the voxels");
    visit("mesh", self.mesh, "the smooth mesh");
    visit("plan", self.plan, "the 2D point and line map; its heights are those of plan_heights");
    visit("plan_heights", self.plan_heights,
          "above the floor, at which plans are drawn: a, b, ... [m]; 1.5 is the paper's example (4.2)");
    visit("grid", self.grid, "the occupancy grid; here its heights count from the floor");
    visit("octomap", self.octomap, "the 3D grid of OctoMap");
    visit("svg", self.svg, "how plans are drawn on paper");
    visit("drawing_points", self.drawing_points, Unit("m"), Range{1e-3, 100.0},
          "the 3D drawing has one point of each scan per cube of this edge; CAD programs take no millions");
    visit("picture_width", self.picture_width, Unit("px"), Range{64, 16384},
          "of the pictures of the model");
  }
};

}  // namespace ariadne::experiments
