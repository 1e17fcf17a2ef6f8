#include "planning/view/ompl_candidates.h"

#include <ompl/base/samplers/BridgeTestValidStateSampler.h>
#include <ompl/base/samplers/GaussianValidStateSampler.h>
#include <ompl/base/samplers/MaximizeClearanceValidStateSampler.h>
#include <ompl/base/samplers/ObstacleBasedValidStateSampler.h>
#include <ompl/base/samplers/UniformValidStateSampler.h>

#include "planning/path/ompl_support.h"
#include "planning/path/roadmap.h"
#include "slam/base/random.h"

namespace ariadne::planning {
namespace {

namespace ob = ompl::base;

std::shared_ptr<ob::ValidStateSampler> MakeOmplSampler(const ob::SpaceInformation* plane,
                                                       CandidateSampler sampler,
                                                       const OmplCandidateOptions& options) {
  if (sampler == CandidateSampler::kObstacleBased)
    return std::make_shared<ob::ObstacleBasedValidStateSampler>(plane);
  if (sampler == CandidateSampler::kGaussian) {
    const auto gaussian = std::make_shared<ob::GaussianValidStateSampler>(plane);
    gaussian->setStdDev(options.std_dev);
    return gaussian;
  }
  if (sampler == CandidateSampler::kBridgeTest) {
    const auto bridge = std::make_shared<ob::BridgeTestValidStateSampler>(plane);
    bridge->setStdDev(options.std_dev);
    return bridge;
  }
  if (sampler == CandidateSampler::kMaximizeClearance) {
    const auto widest = std::make_shared<ob::MaximizeClearanceValidStateSampler>(plane);
    widest->setNrImproveAttempts(static_cast<unsigned>(options.improvements));
    return widest;
  }
  return std::make_shared<ob::UniformValidStateSampler>(plane);
}

}  // namespace

std::vector<Eigen::Vector2d> DrawOmplCandidates(const FreeSpace& space, double radius,
                                                CandidateSampler sampler,
                                                const OmplCandidateOptions& options, std::uint64_t seed) {
  CheckOptions(options, "candidates.");
  internal::RequireRadius(radius);
  if (sampler == CandidateSampler::kUniform) Fail("the sampler uniform is not one of OMPL's");
  if (sampler == CandidateSampler::kRoadmap) {
    // Its vertices are uniform too: with the same numbers they would be those of kOmplUniform.
    RandomStream stream = NamedStream(seed, "view/roadmap");
    return BuildRoadmap(space, radius, {options.count, options.max_draws}, stream()).vertices_map;
  }
  std::vector<Eigen::Vector2d> places;
  if (space.columns() == 0) return places;
  const internal::OmplSilence silence;
  const ob::SpaceInformationPtr plane = internal::PlaneOfDisc(space, radius, seed);
  const auto draw = MakeOmplSampler(plane.get(), sampler, options);
  draw->setNrAttempts(1);  // counted here
  ob::State* state = plane->allocState();
  const auto count = static_cast<std::size_t>(options.count);
  for (std::size_t left = count * static_cast<std::size_t>(options.max_draws);
       left > 0 && places.size() < count; --left) {
    if (draw->sample(state) && plane->isValid(state)) places.push_back(internal::PlaceOf(state));
  }
  plane->freeState(state);
  return places;
}

}  // namespace ariadne::planning
