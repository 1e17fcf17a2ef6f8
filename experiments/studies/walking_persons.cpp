#include "experiments/studies/walking_persons.h"

#include <fmt/format.h>

#include "experiments/run/manifest.h"
#include "experiments/run/run_page.h"
#include "slam/base/error.h"
#include "slam/base/parallel.h"

namespace ariadne::experiments {

void CheckWalkingPersons(const WalkingPersonsOptions& options) {
  const CrossingOptions& crossing = options.crossing;
  if (crossing.slowest > crossing.fastest)
    Fail("crossing.slowest is {} m/s, above crossing.fastest, {} m/s", crossing.slowest, crossing.fastest);
  constexpr double kHall = 9.0;  // of its length, between the ends' distances from the walls [m]
  if (crossing.distance > kHall)
    Fail("crossing.distance is {} m; the hall has {} m", crossing.distance, kHall);
}

std::string RunWalkingPersons(const WalkingPersonsOptions& options, const RunDirectory& run,
                              ProgressDisplay& progress) {
  WriteManifest(run, {});
  const Parallel parallel(options.threads);
  const auto count = static_cast<std::size_t>(options.episodes);
  std::vector<PersonTrial> trials(2 * count);
  constexpr std::size_t kAtOnce = 20;
  for (std::size_t from = 0; from < trials.size(); from += kAtOnce) {
    const double done = static_cast<double>(from) / static_cast<double>(trials.size());
    progress.Show(fmt::format("episode {} of {}, {}", from, trials.size(), progress.Eta(done)));
    parallel.For(std::min(kAtOnce, trials.size() - from), 1, [&](std::size_t i, std::size_t, std::size_t) {
      const std::size_t episode = from + i;
      const std::uint64_t seed =
          static_cast<std::uint64_t>(options.seed) * 1'000'000'007ULL + episode % count;
      trials[episode] = DriveAmongPersons(options.crossing, options.mission, episode < count, seed);
    });
  }
  run.WriteCsv("trials.csv", PersonTrialTable(trials));
  const Table table = PersonTable(trials);
  run.WriteCsv("persons.csv", table);
  run.WriteText("persons.tex", ToLatex(table));
  FinishRun(run, "Persons who cross the robot's way", count);
  return ToText(table);
}

}  // namespace ariadne::experiments
