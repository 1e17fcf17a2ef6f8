#include "experiments/bounds/minimum_cover.h"

#include <gtest/gtest.h>

#include <bit>
#include <limits>
#include <numeric>

#include "experiments/bounds/cover_program.h"
#include "experiments/bounds/greedy_cover.h"
#include "experiments/bounds/swap_search.h"
#include "slam/base/random.h"
#include "tests/support/error_of.h"

namespace ariadne::experiments {
namespace {

double CoveredBy(const CoverProblem& problem, unsigned subset) {
  std::vector<bool> covered(problem.weights.size(), false);
  for (std::size_t s = 0; s < problem.sets.size(); ++s) {
    for (const int i : problem.sets[s]) {
      if (subset >> s & 1u) covered[static_cast<std::size_t>(i)] = true;
    }
  }
  double weight = 0.0;
  for (std::size_t i = 0; i < covered.size(); ++i) weight += covered[i] ? problem.weights[i] : 0.0;
  return weight;
}

/// The size of the smallest cover among all subsets.
int SmallestByTrial(const CoverProblem& problem, double share) {
  const unsigned all = (1u << problem.sets.size()) - 1u;
  const double required = share * CoveredBy(problem, all) * (1.0 - 1e-9);
  int smallest = 32;
  for (unsigned subset = 0; subset <= all; ++subset) {
    if (std::popcount(subset) < smallest && CoveredBy(problem, subset) >= required) {
      smallest = std::popcount(subset);
    }
  }
  return smallest;
}

CoverProblem RandomProblem(std::uint64_t seed, std::size_t sets, std::size_t elements, double density) {
  RandomStream stream = NamedStream(seed, "test/cover");
  CoverProblem problem;
  for (std::size_t i = 0; i < elements; ++i) problem.weights.push_back(DrawUniform(stream, 0.1, 2.0));
  for (std::size_t s = 0; s < sets; ++s) {
    std::vector<int>& set = problem.sets.emplace_back();
    for (int i = static_cast<int>(elements) - 1; i >= 0; --i) {
      if (DrawUniform(stream, 0.0, 1.0) < density) set.push_back(i);
    }
  }
  return problem;
}

/// Views along a closed corridor, each of which sees `reach` pieces on both sides of its own.
CoverProblem Ring(int pieces, int reach) {
  CoverProblem problem;
  problem.weights.assign(static_cast<std::size_t>(pieces), 1.0);
  for (int s = 0; s < pieces; ++s) {
    std::vector<int>& set = problem.sets.emplace_back();
    for (int d = -reach; d <= reach; ++d) set.push_back((s + d + pieces) % pieces);
  }
  return problem;
}

unsigned MaskOf(const std::vector<std::size_t>& chosen) {
  unsigned mask = 0;
  for (const std::size_t set : chosen) mask |= 1u << set;
  return mask;
}

TEST(MinimumCover, IsTheSmallestOfAllSubsets) {
  int beyond_greedy = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const CoverProblem problem = RandomProblem(seed, 12, 10 + seed % 25, seed % 2 == 0 ? 0.2 : 0.3);
    for (const double share : {0.5, 0.8, 0.95, 1.0}) {
      CoverOptions options;
      options.share = share;
      const CoverResult result = MinimumCover(problem, options);
      const int smallest = SmallestByTrial(problem, share);
      EXPECT_EQ(result.chosen.size(), static_cast<std::size_t>(smallest)) << seed << ", " << share;
      EXPECT_TRUE(result.proven);
      EXPECT_EQ(result.lower_bound, smallest);
      EXPECT_LE(result.relaxation, smallest + 1e-6);
      EXPECT_NEAR(result.covered, CoveredBy(problem, MaskOf(result.chosen)), 1e-9);
      EXPECT_NEAR(result.coverable, CoveredBy(problem, 0xfffu), 1e-9);
      EXPECT_GE(result.covered, share * result.coverable * (1.0 - 2e-6));
      beyond_greedy += result.greedy_size - smallest;
    }
  }
  EXPECT_GT(beyond_greedy, 4) << "these problems are too easy to tell the program from greed";
}

TEST(MinimumCover, IsFoundByTheProgramAlone) {
  CoverOptions program_alone;
  program_alone.swaps = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    for (const double share : {0.8, 1.0}) {
      const CoverProblem problem = RandomProblem(seed, 12, 25, 0.2);
      const ReducedCover reduced = ReduceCover(problem, share);
      std::vector<int> all(reduced.sets.size());
      std::iota(all.begin(), all.end(), 0);
      const CoverProgramResult result = SolveCoverProgram(reduced, all, program_alone);
      const int smallest = SmallestByTrial(problem, share);
      EXPECT_EQ(result.chosen.size(), static_cast<std::size_t>(smallest)) << seed << ", " << share;
      EXPECT_EQ(result.bound, smallest);
    }
  }
}

TEST(MinimumCover, IsMostlyFoundBySwaps) {
  int found = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    for (const double share : {0.8, 1.0}) {
      const CoverProblem problem = RandomProblem(seed, 12, 25, 0.2);
      const ReducedCover reduced = ReduceCover(problem, share);
      std::vector<int> all(reduced.sets.size());
      std::iota(all.begin(), all.end(), 0);
      const std::vector<int> chosen = SwapSearch(reduced, all, 1, 100);
      EXPECT_GE(CoveredWeight(reduced, chosen), reduced.required);
      found += static_cast<int>(chosen.size()) == SmallestByTrial(problem, share) ? 1 : 0;
      EXPECT_EQ(SwapSearch(reduced, all, 1, 100), chosen);
    }
  }
  EXPECT_GE(found, 55) << "of 60";
}

TEST(MinimumCover, BoundsWhatItDoesNotSearch) {
  CoverOptions options;
  options.swaps = 0;
  int unproven = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    options.max_nodes = static_cast<int>(seed % 3);
    options.max_iterations = seed % 2 == 0 ? 10 : 1000;
    const CoverProblem problem = RandomProblem(seed, 12, 30, 0.2);
    const CoverResult result = MinimumCover(problem, options);
    const int smallest = SmallestByTrial(problem, options.share);
    EXPECT_LE(result.lower_bound, smallest);
    EXPECT_GE(result.lower_bound, 1);
    EXPECT_GE(static_cast<int>(result.chosen.size()), smallest);
    EXPECT_LE(static_cast<int>(result.chosen.size()), result.greedy_size);
    EXPECT_EQ(result.proven, result.lower_bound == static_cast<int>(result.chosen.size()));
    unproven += result.proven ? 0 : 1;
  }
  EXPECT_GT(unproven, 0);
}

TEST(MinimumCover, OfARingIsKnown) {
  for (const int pieces : {60, 61, 65}) {
    CoverOptions options;
    options.share = 1.0;
    EXPECT_EQ(MinimumCover(Ring(pieces, 2), options).lower_bound, (pieces + 4) / 5);
    options.share = 0.5;
    const CoverResult half = MinimumCover(Ring(pieces, 2), options);
    EXPECT_EQ(static_cast<int>(half.chosen.size()), ((pieces + 1) / 2 + 4) / 5);
    EXPECT_TRUE(half.proven);
  }
}

TEST(MinimumCover, CountsWhatNobodySeesInNothing) {
  // Element 2 is in no set; the rest weighs 20, of which 19 suffice.
  const CoverProblem problem{{19.0, 1.0, 500.0, 0.0}, {{1}, {0, 0}, {3}, {}}};
  const CoverResult result = MinimumCover(problem, {});
  EXPECT_EQ(result.chosen, std::vector<std::size_t>{1});
  EXPECT_DOUBLE_EQ(result.coverable, 20.0);
  EXPECT_DOUBLE_EQ(result.covered, 19.0);
  CoverOptions whole;
  whole.share = 1.0;
  EXPECT_EQ(MinimumCover(problem, whole).chosen, (std::vector<std::size_t>{0, 1}));
}

TEST(MinimumCover, ChoosesTheFirstOfEqualSets) {
  const CoverProblem problem{{1.0, 1.0}, {{0}, {1, 0}, {0, 1}}};
  EXPECT_EQ(MinimumCover(problem, {}).chosen, std::vector<std::size_t>{1});
}

TEST(MinimumCover, RepeatsItself) {
  const CoverProblem problem = RandomProblem(7, 40, 120, 0.1);
  CoverOptions options;
  options.max_nodes = 20;
  const CoverResult first = MinimumCover(problem, options);
  const CoverResult second = MinimumCover(problem, options);
  EXPECT_EQ(first.chosen, second.chosen);
  EXPECT_EQ(first.lower_bound, second.lower_bound);
  EXPECT_EQ(first.relaxation, second.relaxation);
}

TEST(MinimumCover, PrintsNothing) {
  testing::internal::CaptureStdout();
  MinimumCover(RandomProblem(8, 30, 100, 0.1), {});
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

TEST(MinimumCover, RefusesWhatIsNoProblem) {
  EXPECT_EQ(ErrorOf([] { MinimumCover({}, {}); }), "none of the 0 sets covers anything");
  EXPECT_EQ(ErrorOf([] { MinimumCover({{1.0}, {{}, {}}}, {}); }), "none of the 2 sets covers anything");
  EXPECT_EQ(ErrorOf([] { MinimumCover({{0.0}, {{0}}}, {}); }), "none of the 1 sets covers anything");
  EXPECT_EQ(ErrorOf([] { MinimumCover({{1.0}, {{0, 1}}}, {}); }), "set 0 has element 1, but there are 1");
  EXPECT_EQ(ErrorOf([] { MinimumCover({{1.0, -2.0}, {{0}}}, {}); }), "element 1 to be covered weighs -2");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(ErrorOf([&] { MinimumCover({{nan}, {{0}}}, {}); }), "");
  CoverOptions options;
  options.share = 0.0;
  EXPECT_NE(ErrorOf([&] { MinimumCover({{1.0}, {{0}}}, options); }).find("cover.share"), std::string::npos);
}

}  // namespace
}  // namespace ariadne::experiments
