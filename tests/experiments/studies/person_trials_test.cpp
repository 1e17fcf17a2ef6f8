#include "experiments/studies/person_trials.h"

#include <gtest/gtest.h>

namespace ariadne::experiments {
namespace {

PersonTrial Sum(const CrossingOptions& options, bool avoid, int episodes) {
  PersonTrial sum;
  sum.reached = true;
  for (int i = 0; i < episodes; ++i) {
    const PersonTrial trial = DriveAmongPersons(options, {}, avoid, 100 + static_cast<std::uint64_t>(i));
    sum.reached = sum.reached && trial.reached;
    sum.contacts += trial.contacts, sum.needless += trial.needless, sum.duration += trial.duration;
  }
  return sum;
}

TEST(PersonTrials, ReachTheGoalWithoutANeedlessContact) {
  constexpr int kEpisodes = 8;
  const PersonTrial looking = Sum({}, true, kEpisodes);
  EXPECT_TRUE(looking.reached);
  EXPECT_EQ(looking.needless, 0);
  const PersonTrial blind = Sum({}, false, kEpisodes);
  EXPECT_GT(blind.needless, 0) << "the persons are in the way";
}

TEST(PersonTrials, AreFastWithoutPersons) {
  const PersonTrial alone = DriveAmongPersons({.persons = 0}, {}, true, 1);
  EXPECT_TRUE(alone.reached);
  EXPECT_EQ(alone.given_up, 0);
  EXPECT_LT(alone.duration, 20.0);
}

TEST(PersonTable, AddsUpByWay) {
  const std::vector<PersonTrial> trials{
      {"a", true, 1, 0, 0, 2, 10.0}, {"b", true, 0, 0, 0, 0, 8.0}, {"a", false, 3, 2, 1, 0, 30.0}};
  const Table table = PersonTable(trials);
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.rows[0],
            (std::vector<std::string>{"a", "2", "50.0", "4", "2", "1", "2", "20.0", "29.0"}));
}

}  // namespace
}  // namespace ariadne::experiments
