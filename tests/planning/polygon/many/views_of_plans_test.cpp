#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "drivers/simulated/plan_world.h"
#include "tests/planning/polygon/visible_overlap.h"

namespace ariadne::planning {
namespace {

struct Overlaps {
  std::vector<double> exact, noisy;
};

std::vector<std::string> PlanFiles() {
  const char* data = std::getenv("ARIADNE_DATA");
  std::vector<std::string> files;
  if (data == nullptr || !std::filesystem::exists(std::string(data) + "/plans")) return files;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(data) + "/plans")) {
    if (entry.path().extension() == ".json") files.push_back(entry.path().string());
  }
  std::ranges::sort(files);
  return files;
}

void AppendOverlaps(const drivers::RayScene& scene, const slam::Pose2& T_map_scan, Overlaps& overlaps) {
  drivers::AisScannerOptions scanner;
  const std::uint64_t number = overlaps.noisy.size();
  const slam::PosedCloud noisy = SweepAt(scene, T_map_scan, scanner, number);
  scanner.range_finder = drivers::WithoutErrors(scanner.range_finder);
  const slam::PosedCloud exact = SweepAt(scene, T_map_scan, scanner, number);
  for (const slam::PosedCloud* scan : {&exact, &noisy}) {
    const LabelledPolygon polygon = ScanPolygon(*scan);
    RequireSimple(polygon);
    (scan == &exact ? overlaps.exact : overlaps.noisy)
        .push_back(OverlapWithVisible(polygon, scene, T_map_scan));
  }
}

double MedianOf(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

// Seven views of each of the 30 plans, by one horizontal sweep with beams 1 degree apart.
TEST(ScanPolygon, IsWhatCanBeSeenInThePlans) {
  const std::vector<std::string> files = PlanFiles();
  if (files.empty())
    GTEST_SKIP() << "needs the floor plans: ARIADNE_DATA is not set to a folder with plans/";
  RandomStream stream = NamedStream(1, "views");
  Overlaps overlaps;
  for (const std::string& file : files) {
    const drivers::RayScene scene(drivers::ReadPlanWorld(file));
    for (const slam::Pose2& view : DrawViews(stream, scene, 7)) AppendOverlaps(scene, view, overlaps);
  }
  ASSERT_GE(overlaps.exact.size(), 200U);
  EXPECT_GE(MedianOf(overlaps.exact), 0.99);
  EXPECT_GE(MedianOf(overlaps.noisy), 0.97);
}

}  // namespace
}  // namespace ariadne::planning
