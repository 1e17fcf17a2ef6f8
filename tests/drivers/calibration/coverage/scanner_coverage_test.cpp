// Over many rooms the errors of the calibration are as large as its covariance says, and without bias.
#include <gtest/gtest.h>
#include <Eigen/Cholesky>

#include "drivers/calibration/calibrate_scanner.h"
#include "experiments/metrics/nees.h"
#include "tests/drivers/calibration/measured_room.h"

namespace ariadne::drivers {
namespace {

TEST(CalibrateScanner, KnowsHowFarItErrs) {
  constexpr int kRooms = 100;
  constexpr int kSize = ScannerMounting::kSize;
  ScannerMounting::Vector sum = ScannerMounting::Vector::Zero(), variance = sum, covered = sum;
  std::vector<double> nees;
  for (int seed = 0; seed < kRooms; ++seed) {
    RandomStream stream = NamedStream(static_cast<std::uint64_t>(seed), "coverage");
    RoomScanOptions options;
    options.truth = CrookedMounting();
    options.truth.range_offset = DrawNormal(stream, 0.0, 0.015);  // as the data sheet has it
    options.slices = 128;
    options.yaw = DrawUniform(stream, -3.0, 3.0);
    const ScannerCalibration result = CalibrateOnPlanes(ScanRoom(options, stream).planes, {});
    const ScannerMounting::Vector error = result.mounting.ToVector() - options.truth.ToVector();
    const ScannerMounting::Vector sigma = result.covariance.diagonal().cwiseSqrt();
    sum += error;
    variance += sigma.cwiseAbs2();
    for (int i = 0; i < kSize; ++i) covered[i] += std::abs(error[i]) < 2.0 * sigma[i] ? 1.0 : 0.0;
    nees.push_back(error.dot(result.covariance.ldlt().solve(error)));
  }
  const experiments::NeesSummary summary = experiments::SummarizeNees(nees, 0.95, kSize);
  const ScannerMounting::Vector bias = sum / kRooms;
  const ScannerMounting::Vector mean_sigma = (variance / kRooms).cwiseSqrt();
  for (int i = 0; i < kSize; ++i) {
    RecordProperty("bias_over_sigma_" + std::to_string(i), std::to_string(bias[i] / mean_sigma[i]));
    EXPECT_LT(std::abs(bias[i]), 0.35 * mean_sigma[i]) << i;  // 3.5 sigmas of a mean of 100
    EXPECT_GE(covered[i], 88.0) << i;                         // 95.4 expected
  }
  std::printf("mean NEES %.2f of %d (%.2f to %.2f), %.0f %% within the 95 %% bound\n", summary.mean, kSize,
              summary.band.low, summary.band.high, 100.0 * summary.share_within);
  EXPECT_GT(summary.mean, 0.75 * kSize);
  EXPECT_LT(summary.mean, 1.3 * kSize);
}

}  // namespace
}  // namespace ariadne::drivers
