// A line that was recorded makes the driver do and see all of it once more.
#include <gtest/gtest.h>

#include "drivers/hardware/recorded_lines.h"
#include "tests/drivers/emulated/lms200_bench.h"

namespace ariadne::drivers {
namespace {

/// Sweeps over a line, up to the end of its recording.
std::vector<Lms200Sweep> TakeSome(std::unique_ptr<ByteStream> line, int count) {
  Lms200 driver(std::move(line), With(180, 0.5));
  driver.StartStream();
  std::vector<Lms200Sweep> sweeps;
  for (int i = 0; i < count; ++i) sweeps.push_back(driver.NextSweep());
  driver.StopStream();
  return sweeps;
}

TEST(ReplayedLine, GivesTheSameSweepsToTheLastBit) {
  SweepLog log;
  EmulatedLms200 device({}, [&](double stamp, const slam::ScannerModel& scanner, std::size_t beams) {
    return log.Take(stamp, scanner, beams);
  });
  auto line = std::make_unique<EmulatedLine>(device);
  RandomStream stream = NamedStream(1, "replayed faults");
  for (int i = 0; i < 20; ++i) line->Inject(DrawFault(stream, 2.0, 60.0));
  std::vector<LineRecord> records;
  auto recording = std::make_unique<RecordingStream>(
      std::move(line), [&](const LineRecord& record) { records.push_back(record); });
  const std::vector<Lms200Sweep> live = TakeSome(std::move(recording), 1000);
  RecordedLines recorded = OneRecordedLine(records);
  const std::vector<Lms200Sweep> again = TakeSome(recorded.Open(0), 1000);
  recorded.ExpectEnd();
  EXPECT_EQ(recorded.departure(), "");
  ASSERT_EQ(again.size(), live.size());
  for (std::size_t i = 0; i < live.size(); ++i) {
    EXPECT_EQ(again[i].sweep.stamp, live[i].sweep.stamp);
    EXPECT_EQ(again[i].no_distance, live[i].no_distance);
    for (std::size_t beam = 0; beam < live[i].sweep.ranges.size(); ++beam) {
      const float one = live[i].sweep.ranges[beam];
      const float other = again[i].sweep.ranges[beam];
      ASSERT_TRUE(one == other || (std::isnan(one) && std::isnan(other)));
    }
  }
}

}  // namespace
}  // namespace ariadne::drivers
