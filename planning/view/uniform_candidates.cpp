#include "planning/view/uniform_candidates.h"

#include <algorithm>
#include <cmath>

#include "slam/base/random.h"
#include "slam/geometry/triangulate.h"

namespace ariadne::planning {
namespace {

/// Triangles, each as likely as it is large.
class TriangleSampler {
 public:
  explicit TriangleSampler(slam::Triangles2 mesh) : mesh_(std::move(mesh)) {
    double sum = 0.0;
    for (const auto& [a, b, c] : mesh_.triangles) {
      sum += slam::SignedArea({mesh_.vertices[a], mesh_.vertices[b], mesh_.vertices[c]});
      area_up_to_.push_back(sum);
    }
  }

  bool IsEmpty() const { return area_up_to_.empty(); }

  Eigen::Vector2d Draw(RandomStream& stream) const {
    const double at = DrawUniform(stream, 0.0, area_up_to_.back());
    const auto found = std::ranges::upper_bound(area_up_to_, at);
    const auto last = static_cast<std::ptrdiff_t>(area_up_to_.size()) - 1;  // rounding may reach the end
    const auto& [a, b, c] =
        mesh_.triangles[static_cast<std::size_t>(std::min(found - area_up_to_.begin(), last))];
    double u = DrawUniform(stream, 0.0, 1.0), v = DrawUniform(stream, 0.0, 1.0);
    if (u + v > 1.0) u = 1.0 - u, v = 1.0 - v;  // the other half of the parallelogram
    const Eigen::Vector2d& corner = mesh_.vertices[a];
    return corner + u * (mesh_.vertices[b] - corner) + v * (mesh_.vertices[c] - corner);
  }

 private:
  slam::Triangles2 mesh_;
  std::vector<double> area_up_to_;  // [m^2]
};

bool IsWithin(std::span<const slam::Polygon2> area, const Eigen::Vector2d& p) {
  return std::ranges::any_of(area, [&](const slam::Polygon2& part) { return slam::Contains(part, p); });
}

bool KeepsClear(std::span<const Edge> edges, const Eigen::Vector2d& p, const CandidateOptions& options) {
  if (options.wall_clearance == 0.0 && options.unseen_clearance == 0.0) return true;
  return std::ranges::all_of(edges, [&](const Edge& edge) {
    return Distance(edge, p) >= (edge.seen ? options.wall_clearance : options.unseen_clearance);
  });
}

}  // namespace

std::vector<Eigen::Vector2d> DrawWantedCandidates(std::span<const slam::Polygon2> area,
                                                  std::span<const Edge> edges,
                                                  const CandidateOptions& options, std::uint64_t seed,
                                                  int count, const IsWantedCandidate& is_wanted) {
  CheckOptions(options, "candidates.");
  RequirePlaces(edges);
  const TriangleSampler sampler(slam::Triangulated(area));
  std::vector<Eigen::Vector2d> wanted;
  if (sampler.IsEmpty()) return wanted;
  RandomStream stream = NamedStream(seed, "view/candidates");
  int drawn = 0;
  for (long left = static_cast<long>(options.count) * options.max_draws;
       left > 0 && drawn < options.count && wanted.size() < static_cast<std::size_t>(count); --left) {
    const Eigen::Vector2d p = sampler.Draw(stream);
    const bool is_one = is_wanted(p);
    // The triangles are rounded to 0.1 mm and may stand out by that.
    if (!(is_one || IsWithin(area, p)) || !KeepsClear(edges, p, options)) continue;
    ++drawn;
    if (is_one) wanted.push_back(p);
  }
  return wanted;
}

std::vector<Eigen::Vector2d> DrawCandidates(std::span<const slam::Polygon2> area,
                                            std::span<const Edge> edges, const CandidateOptions& options,
                                            std::uint64_t seed) {
  return DrawWantedCandidates(area, edges, options, seed, options.count,
                              [&](const Eigen::Vector2d& p) { return IsWithin(area, p); });
}

}  // namespace ariadne::planning
