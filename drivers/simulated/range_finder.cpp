#include "drivers/simulated/range_finder.h"

#include <fmt/format.h>

#include <numbers>
#include <optional>

#include "drivers/simulated/beam_cone.h"

namespace ariadne::drivers {
namespace {

/// Share of white paper's light, by the law that the options ask for.
double ReflectanceShare(const Echo& echo, ReflectanceLaw law) {
  if (law == ReflectanceLaw::kInverseSquare) return echo.light;  // white paper at 1 m sends back 1
  return echo.light * echo.distance * echo.distance;
}

/// The echoes of all beams of a sweep, free of noise.
class EchoFinder {
 public:
  EchoFinder(const RayScene& scene, const RangeFinderOptions& options)
      : scene_(scene), options_(options), cone_(options) {}

  std::vector<std::optional<Echo>> Find(std::span<const Ray> beams, RandomStream turns) {
    std::vector<Ray> rays;
    rays.reserve(beams.size() * cone_.weights().size());
    for (const Ray& beam : beams) {
      const double turn = options_.mixed_pixels ? DrawUniform(turns, 0.0, 2.0 * std::numbers::pi) : 0.0;
      cone_.AppendRays(beam, turn, rays);
    }
    std::vector<Hit> hits(rays.size());
    scene_.Cast(rays, hits);
    std::vector<std::optional<Echo>> echoes;
    echoes.reserve(beams.size());
    for (std::size_t first = 0; first < rays.size(); first += cone_.weights().size()) {
      echoes.push_back(EchoOf(rays, hits, first));
    }
    return echoes;
  }

 private:
  std::optional<Echo> EchoOf(std::span<const Ray> rays, std::span<const Hit> hits, std::size_t first) {
    returns_.clear();
    for (std::size_t i = 0; i < cone_.weights().size(); ++i) {
      const Hit& hit = hits[first + i];
      if (!hit.hit()) continue;
      const double cosine = std::abs(hit.normal_map.dot(rays[first + i].direction_map));
      returns_.push_back({hit.distance, cone_.weights()[i], hit.reflectance * cosine});
    }
    return ChooseEcho(returns_, options_);
  }

  const RayScene& scene_;
  const RangeFinderOptions& options_;
  BeamCone cone_;
  std::vector<RayReturn> returns_;
};

}  // namespace

RangeFinder::RangeFinder(std::string name, const RangeFinderOptions& options, std::uint64_t seed)
    : name_(std::move(name)),
      options_(options),
      seed_(seed),
      systematic_(options, NamedStream(seed, name_ + "/systematic")) {
  CheckOptions(options_, name_ + ".");
}

RandomStream RangeFinder::Stream(std::string_view source, std::string_view sweep_name) const {
  return NamedStream(seed_, fmt::format("{}/{}/{}", name_, source, sweep_name));
}

slam::LaserSweep RangeFinder::Measure(const RayScene& scene, std::span<const Ray> beams,
                                      std::string_view sweep_name) const {
  EchoFinder finder(scene, options_);
  const auto echoes = finder.Find(beams, Stream("mixed_pixels", sweep_name));
  RandomStream noise = Stream("range", sweep_name);
  RandomStream dropouts = Stream("dropouts", sweep_name);
  slam::LaserSweep sweep;
  for (const std::optional<Echo>& echo : echoes) {
    const double error = options_.range_noise ? DrawNormal(noise, 0.0, options_.range_sigma) : 0.0;
    const bool dropped = options_.dropouts && DrawUniform(dropouts, 0.0, 1.0) < options_.dropout_share;
    const bool returned = echo && !dropped;
    sweep.ranges.push_back(
        returned ? ReportedRange(echo->distance + systematic_.At(echo->distance) + error, options_)
                 : slam::LaserSweep::kNoReturn);
    if (options_.reflectance == ReflectanceOutput::kNone) continue;
    const double share = returned ? ReflectanceShare(*echo, options_.reflectance_law) : 0.0;
    sweep.reflectance.push_back(ReportedReflectance(share, options_.reflectance));
  }
  return sweep;
}

}  // namespace ariadne::drivers
