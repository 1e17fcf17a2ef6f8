#include "experiments/studies/matching_ways.h"

#include <fmt/ranges.h>

#include <algorithm>

#include "slam/base/error.h"

namespace ariadne::experiments {

std::vector<std::string> MatchingWays() {
  constexpr auto& kMethods = EnumNames<slam::MatchMethod>::value;
  std::vector<std::string> ways(kMethods.begin(), kMethods.end());
  ways.emplace_back("edges");
  return ways;
}

slam::MapperOptions MatchedBy(const std::string& way, slam::MapperOptions options) {
  if (way == "edges") {
    options.registration.method = slam::MatchMethod::kPairwise;
    options.registration.points = slam::MatchPoints::kEdges;
    options.icp.metric = slam::Metric::kPointToPoint;  // the ends of lines lie on no surface
    return options;
  }
  constexpr auto& kMethods = EnumNames<slam::MatchMethod>::value;
  const auto found = std::ranges::find(kMethods, way);
  if (found == kMethods.end()) Fail("{} is none of {}", way, fmt::join(MatchingWays(), ", "));
  options.registration.method = static_cast<slam::MatchMethod>(found - kMethods.begin());
  return options;
}

}  // namespace ariadne::experiments
