#include "experiments/run/progress_display.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ariadne::experiments {
namespace {

std::string Shown(bool quiet) {
  testing::internal::CaptureStderr();
  ProgressDisplay progress(quiet);
  progress.Show("passing");
  progress.Keep("finished");
  return testing::internal::GetCapturedStderr();
}

TEST(ProgressDisplay, WritesOnlyFinishedStepsIntoALogFile) { EXPECT_EQ(Shown(false), "finished\n"); }

TEST(ProgressDisplay, LeavesNoEmptyLine) {
  testing::internal::CaptureStderr();
  ProgressDisplay(false).Keep("");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(ProgressDisplay, IsSilentIfAskedTo) { EXPECT_EQ(Shown(true), ""); }

TEST(ProgressDisplay, DoesNotGuessTheEndBeforeItHasBegun) {
  const ProgressDisplay progress(true);
  EXPECT_EQ(progress.Eta(0.0), "ETA ?");
  EXPECT_EQ(progress.Eta(1.0), "ETA 0 s");
  EXPECT_THAT(progress.Eta(0.001), testing::MatchesRegex("ETA [0-9]+ s"));
}

}  // namespace
}  // namespace ariadne::experiments
