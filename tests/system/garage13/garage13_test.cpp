// Thirteen real scans of a car park by each of the three methods, on a coarse voxel grid.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/system/program.h"

namespace ariadne {
namespace {

class Garage13 : public ProgramTest, public testing::WithParamInterface<std::string> {
 protected:
  void SetUp() override {
    const fs::path data = slam::testing_support::DataFolder();
    ARIADNE_REQUIRE_DATA(data / "scans/garage13");
    setenv("ARIADNE_DATA", data.c_str(), 1);
    out_ = Must("run '" ARIADNE_SOURCE_DIR "/experiments/configs/garage13_" + GetParam() +
                ".yaml' --set reduce.voxel_size=0.3 --set output.map=false --set output.figures=false "
                "--set icp.threads=2 -q --out run");
  }
  /// The numbers of a line of a CSV file.
  static std::vector<double> Numbers(const std::string& line) {
    std::vector<double> numbers;
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) numbers.push_back(std::stod(cell));
    return numbers;
  }
  std::string out_;
};
INSTANTIATE_TEST_SUITE_P(By, Garage13, testing::Values("pairwise", "metascan", "simultaneous"),
                         [](const auto& method) { return method.param; });

TEST_P(Garage13, IsRegisteredAndEveryOverlappingPairIsCloser) {
  const auto metrics = nlohmann::json::parse(Content("run/metrics.json"));
  EXPECT_EQ(metrics["scans"], 13);
  EXPECT_EQ(metrics["registered"], 13);
  EXPECT_GT(metrics["median_plane_distance_before_m"], 0.04);
  EXPECT_LT(metrics["median_plane_distance_after_m"], 0.02);
  EXPECT_THAT(out_, testing::HasSubstr("\n  12  scan012"));

  std::istringstream residuals(Content("run/residuals.csv"));
  std::string line;
  std::getline(residuals, line);
  EXPECT_THAT(line, testing::StartsWith("model,data,pairs_before,median_before_m,plane_median_before_m,"));
  int neighbours = 0;
  while (std::getline(residuals, line)) {
    const std::vector<double> row = Numbers(line);
    ASSERT_EQ(row.size(), 10U);
    if (row[1] != row[0] + 1) continue;
    ++neighbours;
    EXPECT_LT(row[8], row[4]) << "the surfaces of scans " << row[0] << " and " << row[1];
    EXPECT_LT(row[8], 0.03);
  }
  EXPECT_EQ(neighbours, 12) << "each scan overlaps the one before";
}

}  // namespace
}  // namespace ariadne
