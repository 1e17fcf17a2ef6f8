#pragma once

#include <span>

#include "slam/base/options.h"
#include "slam/geometry/triangle_mesh.h"
#include "slam/scan/point_cloud.h"

namespace ariadne::slam {

struct ScanMeshOptions {
  double max_gap = 2.5;
  double jump = 0.1;
  double max_incidence = 1.4;
  bool smooth = true;
  int smooth_beams = 3;
  double range_sigma = 0.01;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("max_gap", self.max_gap, Unit("beams"), Range{1.1, 100.0},
          "beams further apart are not joined: one lost return between two leaves no hole");
    visit(
        "jump", self.jump, Unit("m"), Range{0.0, 10.0},
        "neighbours may differ so much in range, or in what their own neighbours let expect; 0.1 is above "
        "noise and rough surfaces, below furniture in front of walls");
    visit("max_incidence", self.max_incidence, Unit("rad"), Range{0.1, 1.57},
          "between beam and normal; at 1.4 (80 deg) a range error counts 6 times across the beam");
    visit("smooth", self.smooth, "move points along their beams to the surface through their neighbours");
    visit("smooth_beams", self.smooth_beams, Unit("beams"), Range{1, 20},
          "neighbours on each side that tell the surface; 3 take the noise down to a third and less");
    visit("range_sigma", self.range_sigma, Unit("m"), Range{1e-4, 1.0},
          "of ranges; neighbours that are further off belong to other surfaces. LMS-200: 5 to 10 mm");
  }
};

/// The surface between the neighbouring beams of a scan that an organized cloud holds: triangles that face
/// the scanner, in the frame of the cloud, grey by reflectance where there is some. Where the range jumps
/// there is none, nor where it is seen at a grazing angle. A point's beams are found by its bearing within
/// the slice and the pitch of its slice, as those of ScannerModel; clouds of other scanners are refused
/// where they have no slices. Error for such and for points that are not finite, or options out of their
/// range.
TriangleMesh MeshScan(const PointCloud& cloud_laser, const ScanMeshOptions& options);

struct MeshOfScansOptions {
  ScanMeshOptions scan;
  double cell = 0.15;
  double min_share = 0.5;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("scan", self.scan, "the mesh of each scan");
    visit("cell", self.cell, Unit("m"), Range{0.01, 10.0},
          "in cubes of this edge one scan gives the surface; above the error of registration");
    visit("min_share", self.min_share, Unit(""), Range{0.0, 1.0},
          "of the area that another scan has in a cube: with less, a scan does not stand for it");
  }
};

/// The meshes of registered scans as one, in map coordinates, without what several have seen being there
/// several times: in each cell of space, and for each side of a wall, the scan counts whose beams lie
/// densest on the surface (near and head-on: range / cos incidence, the mean over its triangles there), if
/// it has seen enough of the cell. Ties go to the scan that comes first. Along the borders between scans,
/// gaps and overlaps of up to a triangle's size remain.
TriangleMesh MeshOfScans(std::span<const PosedCloud> scans, const MeshOfScansOptions& options);

}  // namespace ariadne::slam
