#pragma once

#include <cstddef>
#include <vector>

#include "slam/extract/fit_surface.h"
#include "slam/extract/slice_lines.h"

namespace ariadne::slam {

/// A surface while slices add lines to it. Strands of it that are side by side (above a door left and
/// right) may split and join; its outline is made of all of them.
class GrowingSurface {
 public:
  /// Lines that followed each other, one per slice.
  struct Strand {
    std::vector<Eigen::Vector3d> right;  // ends of the lines, first to last
    std::vector<Eigen::Vector3d> left;
    std::size_t slice = 0;  // of the last line
    bool goes_on = true;    // false after it has split or joined

    const Eigen::Vector3d& from() const { return right.back(); }
    const Eigen::Vector3d& to() const { return left.back(); }
  };

  /// Which strand a line of the present slice continues.
  struct Link {
    std::size_t strand = 0;
    const SpatialLine* line = nullptr;
  };

  GrowingSurface(const SpatialLine& line, std::size_t slice);

  const std::vector<Strand>& strands() const { return strands_; }
  std::size_t lines() const { return lines_; }

  /// Whether its lines are far enough apart, by their scatter, to define a plane. Two are, as a rule, on
  /// the floor, but not yet where the lines of a side wall spread from one point beside the scanner.
  bool HasPlane() const;

  /// Of the worse end of a line from the plane, in sigmas of that end and of the plane there. 0 without a
  /// plane.
  double Deviation(const SpatialLine& line, const SliceNoise& noise) const;

  /// Takes the points of a line into the plane.
  void Explain(const SpatialLine& line);

  /// Continues the strands by the lines of a slice. A strand that has several lines, and a line that has
  /// several strands, end what was and begin anew, with a bridge where they face each other.
  void Continue(const std::vector<Link>& links, std::size_t slice);

  /// The surface to all its points; nothing where these are on a line.
  std::optional<PlanarSurface> Fit(const SliceNoise& noise) const;

 private:
  void UpdatePlane();

  std::vector<Strand> strands_;
  std::vector<std::vector<Eigen::Vector3d>> bridges_;  // rings
  std::vector<Eigen::Vector3d> explained_laser_;
  std::size_t lines_ = 0;
  PointMoments moments_;
  Eigen::Vector3d mean_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d axes_ = Eigen::Matrix3d::Identity();  // columns: normal, middle, longest
  Eigen::Vector3d variances_ = Eigen::Vector3d::Zero();
};

/// The point of the segment from a to b that is nearest to p.
Eigen::Vector3d NearestOnSegment(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                 const Eigen::Vector3d& p);

}  // namespace ariadne::slam
