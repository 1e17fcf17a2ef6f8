#include "experiments/studies/fig_04.h"

#include <fmt/format.h>

#include "experiments/render/compose.h"
#include "experiments/render/png_file.h"
#include "experiments/report/map_pictures.h"
#include "experiments/run/manifest.h"
#include "experiments/run/run_page.h"
#include "experiments/studies/matching_table.h"
#include "experiments/studies/matching_ways.h"
#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

struct Panel {
  std::string title;
  std::string method;
};

const std::vector<Panel> kPanels{{"Odometry", "odometry"},
                                 {"(a) Pairwise matching", "pairwise"},
                                 {"(b) Incremental matching", "metascan"},
                                 {"(c) Pairwise matching of edge points", "edges"},
                                 {"(d) Simultaneous matching", "simultaneous"},
                                 {"Graph of relative poses", "graph"},
                                 {"Joint matching", "joint"}};

MatchingTrial Try(const Panel& panel, const Fig04Options& options, const TourScans& scans,
                  const TrueBuilding& building, const Parallel& parallel) {
  if (panel.method == "odometry") {
    std::vector<slam::Pose3> T_odom_laser;
    for (const slam::PosedCloud& scan : scans.scans) T_odom_laser.push_back(scan.T_map_laser);
    return JudgePoses(scans, building, std::move(T_odom_laser), parallel);
  }
  return TryMatching(scans, building, MatchedBy(panel.method, options.mapper), parallel);
}

std::vector<slam::PosedCloud> Placed(const TourScans& scans, const std::vector<slam::Pose3>& T_map_laser) {
  std::vector<slam::PosedCloud> placed = scans.scans;
  for (std::size_t i = 0; i < placed.size(); ++i) placed[i].T_map_laser = T_map_laser[i];
  return placed;
}

}  // namespace

std::string RunFig04(const Fig04Options& options, const RunDirectory& run, ProgressDisplay& progress) {
  if (options.input.folder != "builtin:tour") {
    Fail("fig_04 needs the truth of a tour: input.folder must be builtin:tour, not {}",
         options.input.folder);
  }
  WriteManifest(run, {});
  const Parallel parallel(options.threads);
  const SimulatedTour tour(options.input.tour);
  const TrueBuilding building(tour.scene().world());
  progress.Show(fmt::format("taking {} scans", tour.size()));
  const TourScans scans = TakeTourScans(tour, building, parallel);
  const std::vector<slam::PosedCloud> frame = Placed(scans, scans.T_map_laser_true);
  std::vector<Image> pictures;
  std::vector<LabelledTrial> trials;
  Json timing;
  for (const Panel& panel : kPanels) {
    run.WriteProgress("running", trials.size(), kPanels.size());
    progress.Show(panel.title);
    const MatchingTrial trial = Try(panel, options, scans, building, parallel);
    pictures.push_back(PlainTopPicture(Placed(scans, trial.T_map_laser), frame, panel.title));
    timing[panel.method] = trial.seconds;
    trials.push_back({options.input.tour.odometry_noise, options.input.tour.seed, panel.method, trial});
  }
  WritePng(run.File("figures/fig_04.png"), Grid(pictures, {.columns = 1}));
  const Table table = TrialTable(trials);
  run.WriteCsv("methods.csv", table);
  run.WriteJson("timing.json", timing);
  FinishRun(run, "Fig. 4: scans of a corridor by each way of matching", kPanels.size());
  return ToText(table);
}

}  // namespace ariadne::experiments
