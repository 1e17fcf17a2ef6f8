#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>

#include "drivers/simulated/ais_scanner.h"
#include "drivers/simulated/range_errors.h"
#include "slam/geometry/angles.h"
#include "tests/drivers/simulated/box_room.h"

namespace ariadne::drivers {
namespace {

using slam::Pose3;
using slam::Scan;

using Change = std::function<void(RangeFinderOptions&)>;

/// No errors but those that `change` switches on.
AisScannerOptions Only(const Change& change) {
  AisScannerOptions options;
  options.range_finder = WithoutErrors(options.range_finder);
  change(options.range_finder);
  return options;
}

Scan Take(const World& world, const AisScannerOptions& options, std::uint64_t seed = 1,
          std::uint64_t number = 0, int threads = 2) {
  return TakeAisScan(RayScene(world), {}, 0.0, options, seed, number, Parallel(threads));
}

/// Calls visit(range a, range b) for the beams that return in both scans.
template <typename Visit>
void ForEachReturn(const Scan& a, const Scan& b, const Visit& visit) {
  for (std::size_t s = 0; s < a.sweeps.size(); ++s) {
    for (std::size_t i = 0; i < a.sweeps[s].ranges.size(); ++i) {
      const double ra = a.sweeps[s].ranges[i], rb = b.sweeps[s].ranges[i];
      if (std::isfinite(ra) && std::isfinite(rb)) visit(ra, rb);
    }
  }
}

bool SameBytes(const std::vector<float>& a, const std::vector<float>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

bool Same(const Scan& a, const Scan& b) {
  for (std::size_t s = 0; s < a.sweeps.size(); ++s) {
    if (!SameBytes(a.sweeps[s].ranges, b.sweeps[s].ranges) ||
        !SameBytes(a.sweeps[s].reflectance, b.sweeps[s].reflectance)) {
      return false;
    }
  }
  return a.sweeps.size() == b.sweeps.size();
}

struct Moments {
  double n = 0.0, sum = 0.0, squares = 0.0;
  void Add(double x) {
    n += 1.0;
    sum += x;
    squares += x * x;
  }
  double mean() const { return sum / n; }
};

Moments ErrorsOf(const World& world, const AisScannerOptions& options, std::uint64_t seed) {
  Moments errors;
  ForEachReturn(Take(world, Only([](auto&) {})), Take(world, options, seed),
                [&](double truth, double measured) { errors.Add(measured - truth); });
  return errors;
}

void Noise(RangeFinderOptions& o) { o.range_noise = true; }

TEST(AisNoise, HasTheSigmaThatWasAskedFor) {
  const Moments errors = ErrorsOf(FurnishedRoom(), Only(Noise), 5);
  const double sigma = 0.005;
  // Chi-square with n degrees of freedom is nearly normal around n with variance 2n; the mean has
  // sigma^2/n.
  EXPECT_NEAR(errors.squares / (sigma * sigma), errors.n, 3.3 * std::sqrt(2.0 * errors.n));
  EXPECT_NEAR(errors.mean(), 0.0, 3.3 * sigma / std::sqrt(errors.n));
  EXPECT_EQ(errors.n, 46'336.0);
}

TEST(AisNoise, HasTheBiasOfTheDevice) {
  const AisScannerOptions options = Only([](RangeFinderOptions& o) {
    o.range_noise = o.systematic = true;
    o.systematic_shape = SystematicShape::kConstant;
  });
  for (const std::uint64_t seed : {1, 2, 3}) {
    const SystematicError bias(options.range_finder, NamedStream(seed, "ais/systematic"));
    const Moments errors = ErrorsOf(FurnishedRoom(), options, seed);
    EXPECT_NEAR(errors.mean(), bias.At(1.0), 3.3 * 0.005 / std::sqrt(errors.n));
    EXPECT_GT(std::abs(bias.At(1.0)), 0.001) << "or this test would see nothing";
  }
}

TEST(AisNoise, RoundsToCentimetres) {
  const Scan scan = Take(FurnishedRoom(), Only([](RangeFinderOptions& o) { o.quantize = true; }));
  const Scan truth = Take(FurnishedRoom(), Only([](auto&) {}));
  ForEachReturn(truth, scan, [](double exact, double rounded) {
    EXPECT_LE(std::abs(rounded - exact), 0.005 + 1e-6);
    EXPECT_NEAR(rounded * 100.0, std::round(rounded * 100.0), 1e-4);
  });
}

TEST(AisNoise, IsTheSameWithOneThreadAndTwo) {
  AisScannerOptions options;
  EXPECT_TRUE(Same(Take(FurnishedRoom(), options, 1, 0, 1), Take(FurnishedRoom(), options, 1, 0, 2)));
  options.points = SlicePoints::k361;
  options.slices = 50;
  EXPECT_TRUE(Same(Take(FurnishedRoom(), options, 1, 0, 1), Take(FurnishedRoom(), options, 1, 0, 2)));
}

TEST(AisNoise, DiffersBySeedAndByScan) {
  const AisScannerOptions options;
  const Scan scan = Take(FurnishedRoom(), options, 1, 0);
  EXPECT_TRUE(Same(scan, Take(FurnishedRoom(), options, 1, 0)));
  EXPECT_FALSE(Same(scan, Take(FurnishedRoom(), options, 2, 0)));
  EXPECT_FALSE(Same(scan, Take(FurnishedRoom(), options, 1, 1)));
}

TEST(AisNoise, LeavesTheDrawsOfOtherSourcesAlone) {
  const Scan noise = Take(FurnishedRoom(), Only(Noise));
  const Scan both = Take(FurnishedRoom(), Only([](RangeFinderOptions& o) {
                           o.range_noise = o.dropouts = true;
                           o.dropout_share = 0.1;
                         }));
  double kept = 0.0;
  ForEachReturn(noise, both, [&](double a, double b) {
    EXPECT_EQ(a, b);
    kept += 1.0;
  });
  EXPECT_NEAR(kept / 46'336.0, 0.9, 3.3 * std::sqrt(0.09 / 46'336.0)) << "one in ten is dropped";
}

TEST(AisNoise, DrawsTheSameInEveryWorld) {
  // In the open half of the beams return nothing; the others err as in the room.
  const World room = EmptyRoom({-4, -4, 0}, {4, 4, 3});
  World floor;
  floor.bodies.push_back(BoxBody("floor", {-4, -4, -1}, {4, 4, 0}));
  const Scan room_truth = Take(room, Only([](auto&) {})), room_noisy = Take(room, Only(Noise));
  const Scan floor_truth = Take(floor, Only([](auto&) {})), floor_noisy = Take(floor, Only(Noise));
  std::size_t compared = 0;
  for (std::size_t s = 0; s < 256; ++s) {
    for (std::size_t b = 0; b < 181; ++b) {
      if (std::isnan(floor_noisy.sweeps[s].ranges[b])) continue;
      EXPECT_NEAR(floor_noisy.sweeps[s].ranges[b] - floor_truth.sweeps[s].ranges[b],
                  room_noisy.sweeps[s].ranges[b] - room_truth.sweeps[s].ranges[b], 2e-6);
      ++compared;
    }
  }
  EXPECT_GT(compared, 5'000u);
  EXPECT_LT(compared, 30'000u);
}

TEST(AisNoise, LosesWhatIsTooDarkForItsDistance) {
  const AisScannerOptions options = Only([](RangeFinderOptions& o) { o.limit_by_reflectance = true; });
  for (const double reflectance : {0.05, 0.1, 0.4}) {
    const World hall = EmptyRoom({-60, -60, -60}, {60, 60, 60}, reflectance);
    World walls = EmptyRoom({-1, -30, -30}, {10, 30, 30}, reflectance);
    EXPECT_TRUE(slam::ToPointCloud(Take(hall, options)).empty()) << "60 m are too far";
    const Scan scan = Take(walls, options), truth = Take(walls, Only([](auto&) {}));
    for (std::size_t s = 0; s < scan.sweeps.size(); ++s) {
      for (std::size_t b = 0; b < 181; ++b) {
        const double r = truth.sweeps[s].ranges[b];
        const double cosine = (10.0 - options.mount_x) / r;  // of the wall ahead, the only one that is near
        const bool visible = r * r < 100.0 * reflectance * cosine / 0.1;
        const double x =
            options.mount_x +
            r * (AisMounting(options).T_base_laser.rotation *
                 slam::BeamDirection(
                     scan.scanner, b,
                     scan.sweeps[s].pitch + scan.sweeps[s].pitch_rate * slam::BeamTime(scan.scanner, b)))
                    .x();
        if (x > 9.999) {
          EXPECT_EQ(std::isfinite(scan.sweeps[s].ranges[b]), visible) << r << " m";
        }
      }
    }
  }
}

TEST(AisNoise, MeasuresReflectanceByMaterialAndIncidence) {
  World world = EmptyRoom({-5, -5, 0}, {5, 5, 4}, 0.7);
  AisScannerOptions options =
      Only([](RangeFinderOptions& o) { o.reflectance = ReflectanceOutput::kExact; });
  const Scan scan = Take(world, options);
  const slam::LaserSweep sweep = TakeAisSweep(RayScene(world), Standing({}), 0.0, options, 1, 0);
  EXPECT_NEAR(sweep.reflectance[90], 0.7, 1e-6) << "head-on";
  EXPECT_NEAR(sweep.reflectance[60], 0.7 * std::cos(slam::RadFromDeg(30.0)), 1e-6);
  options.range_finder.reflectance_law = ReflectanceLaw::kInverseSquare;
  const slam::LaserSweep falling = TakeAisSweep(RayScene(world), Standing({}), 0.0, options, 1, 0);
  EXPECT_NEAR(falling.reflectance[90], 0.7 / (4.75 * 4.75), 1e-6);
  options.range_finder.reflectance = ReflectanceOutput::kNone;
  EXPECT_TRUE(TakeAisSweep(RayScene(world), Standing({}), 0.0, options, 1, 0).reflectance.empty());
}

}  // namespace
}  // namespace ariadne::drivers
