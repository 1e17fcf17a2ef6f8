#include "planning/view/ompl_candidates.h"

#include <gtest/gtest.h>

#include <array>

#include "slam/geometry/polygon2.h"
#include "tests/planning/view/simple_room.h"
#include "tests/support/error_of.h"

namespace ariadne::planning {
namespace {

constexpr std::array kOmplSamplers{CandidateSampler::kOmplUniform,       CandidateSampler::kObstacleBased,
                                   CandidateSampler::kGaussian,          CandidateSampler::kBridgeTest,
                                   CandidateSampler::kMaximizeClearance, CandidateSampler::kRoadmap};

/// To the walls of the hall, by all edges.
double HallClearance(const Eigen::Vector2d& p) {
  double nearest = slam::Contains(Hall(), p) ? 1e9 : 0.0;
  for (const Edge& edge : EdgesOf(Hall(), true)) nearest = std::min(nearest, Distance(edge, p));
  return nearest;
}

TEST(OmplCandidates, HaveRoomForTheDiscAndFollowTheSeed) {
  const std::array area{Hall()};
  const FreeSpace space(area);
  for (const CandidateSampler sampler : kOmplSamplers) {
    const auto places = DrawOmplCandidates(space, 0.4, sampler, {}, 1);
    EXPECT_EQ(places.size(), 200u) << NameOf(sampler);
    for (const Eigen::Vector2d& p : places) EXPECT_GE(HallClearance(p), 0.4 - 1e-6) << NameOf(sampler);
    EXPECT_NE(places, DrawOmplCandidates(space, 0.4, sampler, {}, 2)) << NameOf(sampler);
    EXPECT_EQ(places, DrawOmplCandidates(space, 0.4, sampler, {}, 1)) << NameOf(sampler);
  }
}

/// Otherwise one of them would be compared twice.
TEST(OmplCandidates, AreOthersWithEachSampler) {
  const std::array area{Hall()};
  const FreeSpace space(area);
  std::vector<Eigen::Vector2d> first;
  for (const CandidateSampler sampler : kOmplSamplers)
    first.push_back(DrawOmplCandidates(space, 0.4, sampler, {}, 1).front());
  for (std::size_t i = 0; i < first.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_NE(first[i], first[k]) << NameOf(kOmplSamplers[i]) << " " << NameOf(kOmplSamplers[k]);
  }
}

double MeanClearance(const FreeSpace& space, CandidateSampler sampler) {
  OmplCandidateOptions options;
  options.count = 1000;
  double sum = 0.0;
  const auto places = DrawOmplCandidates(space, 0.4, sampler, options, 3);
  for (const Eigen::Vector2d& p : places) sum += HallClearance(p) / static_cast<double>(places.size());
  return sum;
}

TEST(OmplCandidates, SamplersPreferWhatTheyAreNamedAfter) {
  const std::array area{Hall()};
  const FreeSpace space(area);
  const double uniform = MeanClearance(space, CandidateSampler::kOmplUniform);
  EXPECT_NEAR(MeanClearance(space, CandidateSampler::kRoadmap), uniform, 0.1);
  EXPECT_LT(MeanClearance(space, CandidateSampler::kObstacleBased), uniform - 0.3);
  EXPECT_LT(MeanClearance(space, CandidateSampler::kGaussian), uniform - 0.3);
  EXPECT_LT(MeanClearance(space, CandidateSampler::kBridgeTest), uniform - 0.1);
  EXPECT_GT(MeanClearance(space, CandidateSampler::kMaximizeClearance), uniform + 0.3);
}

TEST(OmplCandidates, AreUniformWhereTheyAreSaidToBe) {
  const std::array area{slam::Polygon2{Rectangle(0.0, 0.0, 4.0, 4.0), {}}};
  OmplCandidateOptions options;
  options.count = 8000;
  std::array<int, 16> found{};  // by cells of 0.75 m of the inner square, 3 m wide
  for (const Eigen::Vector2d& p :
       DrawOmplCandidates(FreeSpace(area), 0.5, CandidateSampler::kOmplUniform, options, 1)) {
    ++found[static_cast<std::size_t>(static_cast<int>((p.y() - 0.5) / 0.75) * 4 +
                                     static_cast<int>((p.x() - 0.5) / 0.75))];
  }
  for (const int n : found) EXPECT_NEAR(n, 500, 4.5 * std::sqrt(500.0));
}

TEST(OmplCandidates, AreFewerWhereThereIsNoRoom) {
  const std::array area{slam::Polygon2{Rectangle(0.0, 0.0, 2.0, 2.0), {}}};
  const FreeSpace space(area);
  for (const CandidateSampler sampler : kOmplSamplers) {
    EXPECT_TRUE(DrawOmplCandidates(space, 1.1, sampler, {}, 1).empty()) << NameOf(sampler);
    EXPECT_TRUE(DrawOmplCandidates(FreeSpace({}), 0.3, sampler, {}, 1).empty()) << NameOf(sampler);
  }
}

TEST(OmplCandidates, RefuseWhatIsNoDisc) {
  const FreeSpace nothing({});
  EXPECT_NE(ErrorOf([&] { DrawOmplCandidates(nothing, -0.1, CandidateSampler::kGaussian, {}, 1); }), "");
  EXPECT_EQ(ErrorOf([&] { DrawOmplCandidates(nothing, 0.3, CandidateSampler::kUniform, {}, 1); }),
            "the sampler uniform is not one of OMPL's");
  OmplCandidateOptions options;
  options.std_dev = 0.0;
  EXPECT_NE(ErrorOf([&] {
              DrawOmplCandidates(nothing, 0.3, CandidateSampler::kGaussian, options, 1);
            }).find("candidates.std_dev"),
            std::string::npos);
}

}  // namespace
}  // namespace ariadne::planning
