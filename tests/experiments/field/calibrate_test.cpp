#include "experiments/field/calibrate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "drivers/replay/robot_log.h"
#include "tests/drivers/calibration/measured_room.h"
#include "tests/slam/io/support.h"

namespace ariadne::experiments {
namespace {

using testing::HasSubstr;

class CalibrateFiles : public testing::Test {
 protected:
  static std::vector<drivers::DrivenSquare> Read(const std::string& text) {
    std::istringstream in(text);
    return ReadSquares(in, "squares.txt");
  }
  slam::testing_support::TemporaryFolder folder_;
};

TEST_F(CalibrateFiles, SquaresAreALineEach) {
  const auto squares = Read("# measured on Monday\nccw 0.1 -0.2\n\ncw,-0.3, 0.4 # slipped?\n");
  ASSERT_EQ(squares.size(), 2U);
  EXPECT_TRUE(squares[0].counterclockwise);
  EXPECT_FALSE(squares[1].counterclockwise);
  EXPECT_EQ(squares[1].error, Eigen::Vector2d(-0.3, 0.4));
  for (const char* wrong : {"left 0.1 0.2", "cw 0.1", "cw 0.1 0.2 0.3", "cw 0.1 nan", "cw a b"})
    EXPECT_THAT(ErrorOf([&] { Read(std::string("\n") + wrong); }), HasSubstr("squares.txt:2: expected"));
}

TEST_F(CalibrateFiles, WheelsComeAsLinesForTheConfiguration) {
  std::string text;
  for (int i = 0; i < 10; ++i) {
    const Eigen::Vector2d error = drivers::SquareError(i % 2 == 0, 1.004, 0.99, 4.0, 0.5);
    text += fmt::format("{} {} {}\n", i % 2 == 0 ? "ccw" : "cw", error.x() + 1e-4 * (i % 3), error.y());
  }
  folder_.Write("squares.txt", text);
  const std::string found = CalibrateWheelsText(folder_ / "squares.txt", {});
  EXPECT_THAT(found, HasSubstr("radius_ratio: 1.00"));
  EXPECT_THAT(found, HasSubstr("track: 0.49"));
  EXPECT_THAT(ErrorOf([&] { CalibrateWheelsText(folder_ / "none.txt", {}); }), HasSubstr("none.txt"));
}

TEST_F(CalibrateFiles, TheScannersMountComesFromTheLogOfARun) {
  RandomStream stream = NamedStream(1, "room");
  drivers::RoomScanOptions room;
  room.truth = drivers::CrookedMounting();
  room.slices = 128;
  room.beams = 181;
  {
    drivers::RobotLogWriter log(folder_ / "robot.log");
    log.Append(drivers::NowCall{1.0});
    for (int i = 0; i < 3; ++i) log.Append(drivers::ScanCall{drivers::ScanRoom(room, stream).scan});
  }
  EXPECT_EQ(ReadLoggedScans(folder_.path(), 2).size(), 2U);
  const std::string found = CalibrateScannerText({folder_.path().string()}, {});
  EXPECT_THAT(found, HasSubstr("from "));
  const std::size_t at = found.find("    roll: ");
  ASSERT_NE(at, std::string::npos);
  EXPECT_NEAR(std::stod(found.substr(at + 10)), room.truth.roll, 0.002);
  folder_.Write("other/robot.log", "");
  EXPECT_THROW(CalibrateScannerText({(folder_ / "other").string()}, {}), Error);
}

}  // namespace
}  // namespace ariadne::experiments
