#include "slam/extract/hough_lines.h"

#include <algorithm>

#include "slam/extract/hough_accumulator.h"

namespace ariadne::slam {
namespace {

using Points = std::span<const Eigen::Vector2d>;
using IndexList = std::vector<std::size_t>;
using Peak = HoughAccumulator::Peak;

/// What a point has been taken for. An end point of ordered data may serve a second line.
enum class Use : char { kFree, kEnd, kSpent, kOutside };

bool MayServe(Use use) { return use == Use::kFree || use == Use::kEnd; }

/// The points near the line, along the axis that it is steeper to.
IndexList CollectNear(Points points, const std::vector<Use>& uses, const Peak& peak,
                      const HoughOptions& options) {
  const Eigen::Vector2d normal(std::cos(peak.theta), std::sin(peak.theta));
  const double limit = options.line_distance * normal.cwiseAbs().maxCoeff();
  IndexList near;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (MayServe(uses[i]) && std::abs(normal.dot(points[i]) - peak.offset) <= limit) near.push_back(i);
  }
  return near;
}

/// Cuts a sequence of points where two neighbours are apart.
std::vector<IndexList> CutWhere(const IndexList& sequence, const auto& apart) {
  std::vector<IndexList> parts;
  for (const std::size_t i : sequence) {
    if (parts.empty() || apart(parts.back().back(), i)) parts.emplace_back();
    parts.back().push_back(i);
  }
  return parts;
}

std::vector<IndexList> CutOrdered(Points points, const IndexList& near, const HoughOptions& options) {
  return CutWhere(
      near, [&](std::size_t a, std::size_t b) { return (points[b] - points[a]).norm() > options.max_gap; });
}

std::vector<IndexList> CutUnordered(Points points, IndexList near, const Peak& peak,
                                    const HoughOptions& options) {
  const Eigen::Vector2d tangent(-std::sin(peak.theta), std::cos(peak.theta));
  const auto bin_of = [&](std::size_t i) { return std::floor(tangent.dot(points[i]) / options.bin); };
  std::ranges::stable_sort(near, {}, [&](std::size_t i) { return tangent.dot(points[i]); });
  std::vector<IndexList> parts = CutWhere(near, [&](std::size_t a, std::size_t b) {
    return bin_of(b) - bin_of(a) - 1.0 > options.max_empty_bins;
  });
  for (IndexList& part : parts) std::ranges::sort(part);
  return parts;
}

/// Marks the points of a segment and takes their votes back, once.
void Spend(Points points, const LineSegment& segment, const HoughOptions& options, std::vector<Use>& uses,
           HoughAccumulator& accumulator) {
  std::vector<Eigen::Vector2d> spent;
  for (const std::size_t i : segment.points) {
    const bool is_end = i == segment.points.front() || i == segment.points.back();
    if (uses[i] == Use::kFree) spent.push_back(points[i]);
    const bool again = is_end && uses[i] == Use::kFree && options.order == PointOrder::kOrdered;
    uses[i] = again ? Use::kEnd : Use::kSpent;
  }
  accumulator.Withdraw(spent);
}

std::vector<Use> MarkOutside(Points points, double max_distance) {
  std::vector<Use> uses;
  for (const Eigen::Vector2d& p : points) {
    uses.push_back(p.cwiseAbs().maxCoeff() <= max_distance ? Use::kFree : Use::kOutside);
  }
  return uses;
}

std::vector<Eigen::Vector2d> Inside(Points points, const std::vector<Use>& uses) {
  std::vector<Eigen::Vector2d> inside;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (uses[i] != Use::kOutside) inside.push_back(points[i]);
  }
  return inside;
}

}  // namespace

std::vector<LineSegment> DetectByHough(Points points, const HoughOptions& options) {
  CheckOptions(options, "hough.");
  RequireFinite(points);
  std::vector<Use> uses = MarkOutside(points, options.max_distance);
  HoughAccumulator accumulator(Inside(points, uses), options.cells_per_meter);
  std::vector<LineSegment> segments;
  for (int pass = 0; pass < options.max_passes; ++pass) {
    const Peak peak = accumulator.Highest();
    if (peak.votes <= 0) break;
    accumulator.Close(peak);  // what is left of its points is not collected by the same cell again
    const IndexList near = CollectNear(points, uses, peak, options);
    const std::vector<IndexList> parts = options.order == PointOrder::kOrdered
                                             ? CutOrdered(points, near, options)
                                             : CutUnordered(points, near, peak, options);
    for (const IndexList& part : parts) {
      if (part.size() < static_cast<std::size_t>(options.min_points)) continue;
      std::optional<LineSegment> segment = FitSegment(points, part, options.noise);
      if (!segment) continue;
      Spend(points, *segment, options, uses, accumulator);
      segments.push_back(std::move(*segment));
    }
  }
  return segments;
}

}  // namespace ariadne::slam
