#include "slam/extract/grow_surfaces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "slam/geometry/angles.h"

namespace ariadne::slam {

/// A surface that a line may continue.
struct SurfaceGrower::Candidate {
  std::size_t surface = 0;
  std::size_t line = 0;
  bool has_plane = false;
  double deviation = 0.0;                                     // from the plane [sigma]
  double distance = std::numeric_limits<double>::infinity();  // between the middles of the lines [m]
  std::vector<std::size_t> strands;

  auto Rank() const { return std::tuple(!has_plane, deviation, distance, surface, line); }
};

namespace {

using Link = GrowingSurface::Link;
using Strand = GrowingSurface::Strand;

/// A line between two points.
struct Span {
  Eigen::Vector3d from, to;
};

double ToTiltAxis(const Eigen::Vector3d& p) { return std::hypot(p.x(), p.z()); }

/// Of the slice of a line; from its end that is farther from the tilt axis, where it is certain.
double PitchOf(const Span& line) {
  const Eigen::Vector3d& p = ToTiltAxis(line.from) > ToTiltAxis(line.to) ? line.from : line.to;
  return std::atan2(p.z(), p.x());
}

/// Criterion 1 in one direction: both ends of `inner` are in the area around `outer`.
bool IsInArea(const Span& inner, const Span& outer, double pitch_step, const SurfaceOptions& options) {
  const auto near = [&](const Eigen::Vector3d& end) {
    const double apart = ToTiltAxis(end) * pitch_step / std::sin(options.grazing_angle);
    return (NearestOnSegment(outer.from, outer.to, end) - end).norm() <=
           std::max(options.end_distance, apart);
  };
  return near(inner.from) && near(inner.to);
}

/// Criteria 1 and 2 for the last line of a strand and a new line.
bool Continues(const Strand& strand, const SpatialLine& line, const SurfaceOptions& options) {
  const Span last{strand.from(), strand.to()}, next{line.from_laser, line.to_laser};
  const double pitch_step = std::abs(WrapAngle(PitchOf(next) - PitchOf(last)));
  const double cosine = (last.to - last.from).normalized().dot((next.to - next.from).normalized());
  if (std::acos(std::clamp(cosine, -1.0, 1.0)) > options.max_angle + pitch_step) return false;
  return IsInArea(next, last, pitch_step, options) || IsInArea(last, next, pitch_step, options);
}

bool IsOpen(const GrowingSurface& surface, std::size_t slice, int max_missed_slices) {
  return std::ranges::any_of(surface.strands(), [&](const Strand& strand) {
    return strand.goes_on && static_cast<int>(slice - strand.slice) <= max_missed_slices;
  });
}

}  // namespace

SurfaceGrower::SurfaceGrower(const SurfaceOptions& options) : options_(options) {
  CheckOptions(options, "surfaces.");
}

SurfaceGrower::Candidate SurfaceGrower::Compare(const GrowingSurface& surface,
                                                const SpatialLine& line) const {
  Candidate candidate;
  candidate.has_plane = surface.HasPlane();
  for (std::size_t s = 0; s < surface.strands().size(); ++s) {
    const Strand& strand = surface.strands()[s];
    const auto missed = static_cast<int>(slices_ - strand.slice) - 1;
    if (!strand.goes_on || missed > options_.max_missed_slices) continue;
    if (!Continues(strand, line, options_)) continue;
    candidate.strands.push_back(s);
    const Eigen::Vector3d twice = strand.from() + strand.to() - line.from_laser - line.to_laser;
    candidate.distance = std::min(candidate.distance, 0.5 * twice.norm());
  }
  if (!candidate.strands.empty()) candidate.deviation = surface.Deviation(line, options_.noise);
  return candidate;
}

void SurfaceGrower::AddSlice(const std::vector<SpatialLine>& lines) {
  std::vector<Candidate> candidates;
  for (const std::size_t s : open_) {
    for (std::size_t l = 0; l < lines.size(); ++l) {
      Candidate candidate = Compare(surfaces_[s], lines[l]);
      if (candidate.strands.empty() || candidate.deviation > options_.max_deviation) continue;
      candidate.surface = s;
      candidate.line = l;
      candidates.push_back(std::move(candidate));
    }
  }
  std::ranges::sort(candidates, {}, &Candidate::Rank);
  const std::vector<bool> taken = Continue(candidates, lines);
  for (std::size_t l = 0; l < lines.size(); ++l) {
    if (taken[l]) continue;
    open_.push_back(surfaces_.size());
    surfaces_.emplace_back(lines[l], slices_);
  }
  std::erase_if(open_,
                [&](std::size_t s) { return !IsOpen(surfaces_[s], slices_, options_.max_missed_slices); });
  ++slices_;
}

std::vector<bool> SurfaceGrower::Continue(const std::vector<Candidate>& candidates,
                                          const std::vector<SpatialLine>& lines) {
  std::vector<bool> taken(lines.size(), false);
  std::vector<std::vector<Link>> links(surfaces_.size());
  for (const Candidate& candidate : candidates) {
    if (taken[candidate.line]) continue;
    GrowingSurface& surface = surfaces_[candidate.surface];
    const SpatialLine& line = lines[candidate.line];
    // Another line of this slice may have given the surface its plane since.
    if (surface.Deviation(line, options_.noise) > options_.max_deviation) continue;
    surface.Explain(line);
    taken[candidate.line] = true;
    for (const std::size_t strand : candidate.strands) links[candidate.surface].push_back({strand, &line});
  }
  for (const std::size_t s : open_) surfaces_[s].Continue(links[s], slices_);
  return taken;
}

std::vector<PlanarSurface> SurfaceGrower::Surfaces() const {
  std::vector<PlanarSurface> surfaces;
  for (const GrowingSurface& growing : surfaces_) {
    if (growing.lines() < static_cast<std::size_t>(options_.min_lines)) continue;
    std::optional<PlanarSurface> surface = growing.Fit(options_.noise);
    if (surface && Area(*surface) >= options_.min_area) surfaces.push_back(*std::move(surface));
  }
  return surfaces;
}

std::vector<PlanarSurface> GrowSurfaces(const PointCloud& cloud_laser, const LineOptions& line_options,
                                        const SurfaceOptions& options) {
  RequireSlices(cloud_laser, "growing surfaces from lines");
  SurfaceGrower grower(options);
  for (std::size_t slice = 0; slice < cloud_laser.slice_begin.size(); ++slice) {
    grower.AddSlice(SpatialLines(cloud_laser, slice, line_options));
  }
  return grower.Surfaces();
}

}  // namespace ariadne::slam
