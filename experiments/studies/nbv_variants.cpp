#include "experiments/studies/nbv_variants.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <functional>
#include <utility>

#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

using planning::ViewPolicy;

std::vector<NbvVariant> Policies(const ExploreOptions& base) {
  std::vector<NbvVariant> variants{{"policies", "default", base}, {"policies", "paper", base}};
  variants[1].explore.planner = planning::PaperViewPlannerOptions();
  for (const auto policy : {ViewPolicy::kGain, ViewPolicy::kRandom, ViewPolicy::kNearestFrontier,
                            ViewPolicy::kPotentialArea, ViewPolicy::kTwoSteps}) {
    ExploreOptions explore = base;
    explore.planner.policy = policy;
    variants.push_back(
        {"policies", std::string(EnumNames<ViewPolicy>::value[static_cast<std::size_t>(policy)]), explore});
  }
  return variants;
}

/// A number of the planner that takes several values.
template <typename Value>
std::vector<NbvVariant> Numbers(const std::string& study, const ExploreOptions& base,
                                const std::vector<Value>& values,
                                const std::function<void(ExploreOptions&, Value)>& set) {
  std::vector<NbvVariant> variants;
  for (const Value value : values) {
    variants.push_back({study, fmt::format("{} {}", study, value), base});
    set(variants.back().explore, value);
  }
  return variants;
}

void SetFieldOfView(ExploreOptions& explore, double degrees) {
  explore.scanner.field_of_view = degrees;
  explore.planner.view.gain.field_of_view = degrees;
}

/// The paper's gain with the default's weights, and the default's gain with rays' depths.
std::vector<NbvVariant> Gains(const ExploreOptions& base) {
  std::vector<NbvVariant> variants{{"gain", "rays", base}, {"gain", "area until known", base}};
  variants[0].explore.planner.view.gain.measure = planning::GainMeasure::kRays;
  variants[1].explore.planner.view.gain.until_known = true;
  for (const double depth : {2.0, 5.0, 10.0}) {
    variants.push_back({"gain", fmt::format("area {} m", depth), base});
    variants.back().explore.planner.view.gain.depth = depth;
  }
  return variants;
}

/// The paper's candidates beside those of OMPL's samplers: of the same number, in the same free space.
std::vector<NbvVariant> Samplers(const ExploreOptions& base) {
  std::vector<NbvVariant> variants;
  for (std::size_t i = 0; i < EnumNames<planning::CandidateSampler>::value.size(); ++i) {
    variants.push_back({"samplers", std::string(EnumNames<planning::CandidateSampler>::value[i]), base});
    variants.back().explore.planner.sampler = static_cast<planning::CandidateSampler>(i);
  }
  return variants;
}

std::vector<NbvVariant> Ways(const ExploreOptions& base) {
  std::vector<NbvVariant> variants;
  for (std::size_t i = 0; i < EnumNames<planning::WayLength>::value.size(); ++i) {
    variants.push_back({"ways", std::string(EnumNames<planning::WayLength>::value[i]), base});
    variants.back().explore.planner.way = static_cast<planning::WayLength>(i);
  }
  for (const auto way : {ExploreWay::kControllerLength, ExploreWay::kControllerTime}) {
    variants.push_back(
        {"ways", std::string(EnumNames<ExploreWay>::value[static_cast<std::size_t>(way)]), base});
    variants.back().explore.way = way;
  }
  return variants;
}

using MakeVariants = std::function<std::vector<NbvVariant>(const ExploreOptions&)>;

const std::vector<std::pair<std::string, MakeVariants>>& Makers() {
  static const std::vector<std::pair<std::string, MakeVariants>> kMakers{
      {"policies", Policies},
      {"gain", Gains},
      {"samplers", Samplers},
      {"ways", Ways},
      {"candidates",
       [](const ExploreOptions& base) {
         return Numbers<int>("candidates", base, {50, 100, 200, 400, 800},
                             [](ExploreOptions& e, int n) { e.planner.candidates.count = n; });
       }},
      {"c1",
       [](const ExploreOptions& base) {
         return Numbers<double>("c1", base, {0.0, 0.05, 0.08, 0.1, 0.2, 0.5, 1.0, 5.0},
                                [](ExploreOptions& e, double c) { e.planner.view.distance_weight = c; });
       }},
      {"c2",
       [](const ExploreOptions& base) {
         return Numbers<double>("c2", base, {0.0, 0.001, 0.002, 0.005, 0.01},
                                [](ExploreOptions& e, double c) { e.planner.view.angle_weight = c; });
       }},
      {"rest",
       [](const ExploreOptions& base) {
         return Numbers<double>("rest", base, {0.0, 0.5, 1.0, 2.0},
                                [](ExploreOptions& e, double w) { e.planner.view.rest_weight = w; });
       }},
      {"least_share",
       [](const ExploreOptions& base) {
         return Numbers<double>("least_share", base, {0.0, 0.2, 0.4, 0.6},
                                [](ExploreOptions& e, double share) { e.planner.least_share = share; });
       }},
      {"field_of_view",
       [](const ExploreOptions& base) {
         return Numbers<double>("field_of_view", base, {90.0, 180.0, 270.0, 360.0}, SetFieldOfView);
       }},
      {"min_overlap", [](const ExploreOptions& base) {
         return Numbers<double>("min_overlap", base, {0.0, 0.1, 0.2, 0.3, 0.5},
                                [](ExploreOptions& e, double share) { e.planner.min_overlap = share; });
       }}};
  return kMakers;
}

}  // namespace

const std::vector<std::string>& NbvStudyNames() {
  static const std::vector<std::string> kNames = [] {
    std::vector<std::string> names;
    for (const auto& [name, make] : Makers()) names.push_back(name);
    return names;
  }();
  return kNames;
}

std::vector<NbvVariant> NbvVariants(const std::string& study, const ExploreOptions& base) {
  for (const auto& [name, make] : Makers()) {
    if (name == study) return make(base);
  }
  Fail("there is nothing to vary that is named '{}'; there are {}", study,
       fmt::join(NbvStudyNames(), ", "));
}

}  // namespace ariadne::experiments
