#pragma once

#include <vector>

#include "slam/extract/growing_surface.h"
#include "slam/extract/slice_lines.h"

namespace ariadne::slam {

struct SurfaceOptions {
  double end_distance = 0.1;
  double grazing_angle = 0.07;
  double max_angle = 0.17;
  double max_deviation = 5.0;
  int max_missed_slices = 2;
  int min_lines = 3;
  double min_area = 0.02;
  SliceNoise noise;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("end_distance", self.end_distance, Unit("m"), Range{1e-4, 10.0},
          "the least radius of the area in which the ends of the next line lie (2.2.1, open): ends are a "
          "few beams uncertain");
    visit("grazing_angle", self.grazing_angle, Unit("rad"), Range{0.001, 1.5},
          "that radius grows with range times pitch step, as lines on one surface that is met at no less "
          "than this, 4 deg, are no farther apart: on the floor 1 m below, up to 14 m away");
    visit("max_angle", self.max_angle, Unit("rad"), Range{0.0, 1.6},
          "between two lines of a surface, beyond the pitch step by which the lines of a side wall turn; "
          "open, 10 deg, as short lines are uncertain");
    visit("max_deviation", self.max_deviation, Unit("sigma"), Range{0.1, 1000.0},
          "of a line's ends from the plane, by their noise and that of the plane so far from its lines");
    visit("max_missed_slices", self.max_missed_slices, Unit("slices"), Range{0, 100},
          "in which a surface may have no line, and still goes on");
    visit("min_lines", self.min_lines, Unit(""), Range{2, 1000},
          "of a surface; two lines are one by chance");
    visit("min_area", self.min_area, Unit("m^2"), Range{0.0, 100.0},
          "of a surface; open, the least that a person or a chair consists of");
    visit("noise", self.noise, "of the points, for the plane and its covariance");
  }
};

/// The paper's surface detector (Sec. 2.2.1 step 3): as the slices of a scan arrive one by one, their lines
/// continue the surfaces that the slices before have begun. A line continues a surface if
/// 1. its ends are near the surface's last line, or the ends of that line are near it: it may shrink at
///    a door or a cupboard, and grow again,
/// 2. the angle between the two is small,
/// 3. it lies on the plane of the surface; two lines alone have none, and define it.
/// Where several surfaces qualify, the one that has a plane and whose plane is nearest.
class SurfaceGrower {
 public:
  /// Error where an option is out of its range.
  explicit SurfaceGrower(const SurfaceOptions& options);

  /// The lines of the next slice, which may be none.
  void AddSlice(const std::vector<SpatialLine>& lines);

  /// What the slices so far have shown, in the laser frame, in the order in which it was first seen. Planes
  /// are fit to the points; an outline runs up the right ends of the lines and down the left ends.
  std::vector<PlanarSurface> Surfaces() const;

 private:
  struct Candidate;
  /// Which strands of a surface a line may continue, by criteria 1 and 2, and how far it is from the plane.
  Candidate Compare(const GrowingSurface& surface, const SpatialLine& line) const;
  /// Gives the lines to surfaces, the best candidates first; returns which lines have one.
  std::vector<bool> Continue(const std::vector<Candidate>& candidates,
                             const std::vector<SpatialLine>& lines);

  SurfaceOptions options_;
  std::vector<GrowingSurface> surfaces_;  // in the order in which they began
  std::vector<std::size_t> open_;         // those that may go on, ascending
  std::size_t slices_ = 0;
};

/// All of it for a scan that is there already. Error where the cloud is not organized.
std::vector<PlanarSurface> GrowSurfaces(const PointCloud& cloud_laser, const LineOptions& line_options,
                                        const SurfaceOptions& options);

}  // namespace ariadne::slam
