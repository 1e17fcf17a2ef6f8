#include "experiments/studies/run_notes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "drivers/hardware/line_log.h"
#include "tests/slam/io/support.h"

namespace ariadne::experiments {
namespace {

/// Asks a person some times; which of the answers are yes.
std::string AnswersOf(AskedPerson& person) {
  std::string answers;
  for (int i = 0; i < 4; ++i) {
    answers += person.MustStop() ? 's' : '-';
    answers += person.Approves({}) ? 'y' : 'n';
  }
  return answers;
}

/// What a person has decided is noted once, and decided once more by who reads the notes.
TEST(RunNotes, LetAPersonAnswerOnceMore) {
  const slam::testing_support::TemporaryFolder folder;
  std::string lived;
  {
    drivers::LineLogWriter log(folder / "lines.log");
    log.Note(ResumedNote(17));
    log.Note("something else 3");
    log.Note("refused plan x");
    int asked = 0, plan = 0;
    AskedPerson person([&asked] { return ++asked == 3; },
                       [&plan](const PlannedDrive&) { return ++plan != 2; });
    person.NoteTo([&log](const std::string& text) { log.Note(text); });
    lived = AnswersOf(person);
  }
  EXPECT_EQ(lived, "-y-nsysy") << "a stop latches";
  const RunNotes notes = ReadRunNotes(folder / "lines.log");
  EXPECT_EQ(notes, (RunNotes{3, 2, 17}));
  AskedPerson again = AnsweringAs(notes);
  EXPECT_EQ(AnswersOf(again), lived);
}

TEST(RunNotes, OfNobodyStopNothing) {
  AskedPerson nobody({}, {}), again = AnsweringAs({});
  EXPECT_FALSE(nobody.approves_plans());
  EXPECT_EQ(AnswersOf(nobody), "-y-y-y-y");
  EXPECT_EQ(AnswersOf(again), "-y-y-y-y");
}

TEST(RunNotes, SayWhatIsPlanned) {
  PlannedDrive drive;
  EXPECT_EQ(NoteOf(drive), "drive back");
  drive.view.emplace();
  drive.view->p_map = {1.0, -2.5};
  drive.view->gain = 40;
  EXPECT_EQ(NoteOf(drive), "drive to (1.000, -2.500) m for 40 rays");
}

}  // namespace
}  // namespace ariadne::experiments
