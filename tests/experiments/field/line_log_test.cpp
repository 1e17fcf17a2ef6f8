// What is taken out of a log is what the drivers saw when it was written.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "experiments/field/line_log_export.h"
#include "experiments/field/line_log_summary.h"
#include "slam/io/file.h"
#include "slam/io/trajectory.h"
#include "tests/experiments/field/recorded_devices.h"
#include "tests/slam/io/support.h"

namespace ariadne::experiments {
namespace {

using testing::HasSubstr;

class LineLogReport : public testing::Test {
 protected:
  /// Five sweeps, a motion of the servo, and a straight drive.
  void Record() {
    RecordedDevices devices(folder_ / "lines");
    devices.scanner.Connect();
    devices.scanner.StartStream();
    for (int i = 0; i < 5; ++i) sweeps_.push_back(devices.scanner.NextSweep().sweep);
    devices.servo.Connect();
    devices.servo.SetTorque(true);
    devices.servo.SetProfile(1.0, 10.0);
    devices.servo.MoveTo(0.5);
    devices.servo.WaitFor(0.5, 0.002, 5.0);
    devices.motors.Connect();
    devices.motors.SetSpeeds({2000.0, 2000.0}, 1e6);
    for (int i = 0; i < 10; ++i) {
      drivers::DiscardUntil(*devices.lines[2], devices.lines[2]->Now() + 0.1);
      counts_ = devices.motors.Encoders();
    }
  }
  std::vector<std::string> Export(LineLogFormat format, const LineLogExportOptions& options = {}) {
    rows_ = ExportLineLog(folder_ / "lines", format, options, folder_ / "out").rows;
    std::istringstream text(slam::testing_support::ContentOf(folder_ / "out"));
    std::vector<std::string> lines;
    for (std::string line; std::getline(text, line);) lines.push_back(line);
    return lines;
  }

  slam::testing_support::TemporaryFolder folder_;
  std::vector<slam::LaserSweep> sweeps_;
  drivers::roboclaw::EncoderCounts counts_;
  std::size_t rows_ = 0;
};

TEST_F(LineLogReport, TellsWhatIsOnEachLine) {
  Record();
  const LineLogSummary summary = SummarizeLineLog(folder_ / "lines");
  ASSERT_EQ(summary.lines.size(), 3U);
  EXPECT_EQ(summary.files.torn, 0U);
  using drivers::DeviceKind;
  constexpr DeviceKind kKinds[] = {DeviceKind::kLms200, DeviceKind::kDynamixel, DeviceKind::kRoboclaw};
  for (std::size_t i = 0; i < 3; ++i) {
    const LineSummary& line = summary.lines[i];
    EXPECT_EQ(line.seen.kind, kKinds[i]);
    EXPECT_EQ(line.name, "an emulated line");
    EXPECT_GT(line.seen.telegrams, 5U);
    EXPECT_GT(line.bytes_read, 50U);
    EXPECT_GT(line.bytes_written, 20U);
    EXPECT_GT(line.last, line.first);
  }
  EXPECT_TRUE(summary.lines[0].rates.contains(500000));
  EXPECT_EQ(summary.lines[1].seen.bad, 0U);
  EXPECT_EQ(summary.lines[2].seen.bad, 0U);
  EXPECT_EQ(summary.lines[2].seen.telegrams, summary.lines[2].seen.sent);
  EXPECT_THAT(ToText(summary), testing::AllOf(HasSubstr("whole to its end"), HasSubstr("RoboClaw")));
}

TEST_F(LineLogReport, TelegramsSayWhatWasSaid) {
  Record();
  const std::vector<std::string> lines = Export(LineLogFormat::kTelegrams);
  EXPECT_EQ(lines.size(), rows_);
  EXPECT_THAT(lines, testing::Contains(HasSubstr(" 0 > ask for the type")));
  EXPECT_THAT(lines, testing::Contains(HasSubstr(" 0 < type LMS200;30106x;V02.10")));
  EXPECT_THAT(lines, testing::Contains(HasSubstr(" 1 > to 1: write torque 1")));
  EXPECT_THAT(lines, testing::Contains(HasSubstr(" 2 > speeds 2000 2000 with acceleration 1000000")));
  EXPECT_THAT(lines, testing::Contains(HasSubstr(" 2 < Roboclaw")).Times(0));
  EXPECT_THAT(lines, testing::Contains(HasSubstr("Roboclaw 2x15a")));
}

TEST_F(LineLogReport, SweepsAreThoseThatTheDriverTook) {
  Record();
  const std::vector<std::string> lines = Export(LineLogFormat::kSweeps);
  ASSERT_GE(lines.size(), 1 + sweeps_.size());
  std::istringstream row(lines.back());
  std::vector<double> numbers;
  for (std::string cell; std::getline(row, cell, ',');) numbers.push_back(std::stod(cell));
  ASSERT_EQ(numbers.size(), 4U + 181U);
  EXPECT_NEAR(numbers[0], sweeps_.back().stamp + 0.5 / 75.0, 0.003);
  EXPECT_NEAR(numbers[2], 0.0, 1e-9);
  EXPECT_NEAR(numbers[3], std::numbers::pi / 180.0, 1e-6);
  for (std::size_t i = 0; i < 181; ++i) EXPECT_NEAR(numbers[4 + i], sweeps_.back().ranges[i], 1e-3);
}

/// The servo stood at 0 while sweeps were taken, so they lie in the plane, beam 0 to the right.
TEST_F(LineLogReport, PointsLieWhereTheBeamsEnded) {
  Record();
  const std::vector<std::string> lines = Export(LineLogFormat::kXyz);
  double x = 0.0, y = 0.0, z = 1.0;
  std::istringstream(lines.at(0)) >> x >> y >> z;
  EXPECT_NEAR(x, 0.0, 1e-3);
  EXPECT_NEAR(y, -1.0, 1e-3);
  EXPECT_NEAR(z, 0.0, 2e-3);
  EXPECT_EQ(lines.size() % 181, 0U);
}

TEST_F(LineLogReport, OdometryFollowsFromTheCounts) {
  Record();
  const std::vector<std::string> lines = Export(LineLogFormat::kOdometry);
  EXPECT_EQ(rows_, 10U);
  EXPECT_THAT(lines.back(), testing::EndsWith(fmt::format(",{},{}", counts_.counts[0], counts_.counts[1])));
  LineLogExportOptions options;
  options.wheels.ticks_per_turn = 1000;
  options.wheels.wheel_radius = 0.05;
  Export(LineLogFormat::kTum, options);
  const auto poses = slam::ReadFile(folder_ / "out", slam::ReadTum);
  ASSERT_EQ(poses.size(), 10U);
  const double turns = (poses.back().stamp - poses.front().stamp) * 2.0;
  EXPECT_NEAR(poses.back().pose.translation.x(), turns * 2.0 * std::numbers::pi * 0.05, 0.005);
  EXPECT_NEAR(poses.back().pose.translation.y(), 0.0, 1e-9);
}

TEST_F(LineLogReport, SaysWhatALogDoesNotHold) {
  {
    drivers::LineLogWriter log(folder_ / "lines");
    log.Add(0, {drivers::LineRecord::Kind::kRead, 1.0, {1, 2, 3}, 0});
  }
  EXPECT_THAT(ErrorOf([&] { Export(LineLogFormat::kSweeps); }), HasSubstr("holds no sweeps"));
  EXPECT_THAT(ErrorOf([&] { Export(LineLogFormat::kTum); }), HasSubstr("encoders"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
  EXPECT_THAT(ToText(SummarizeLineLog(folder_ / "lines")), HasSubstr("unknown"));
}

}  // namespace
}  // namespace ariadne::experiments
