#include "experiments/studies/catalog.h"

#include <fmt/ranges.h>

#include <algorithm>

#include "experiments/studies/ablation_control.h"
#include "experiments/studies/ablation_features.h"
#include "experiments/studies/ablation_graph.h"
#include "experiments/studies/ablation_matching.h"
#include "experiments/studies/ablation_mission.h"
#include "experiments/studies/ablation_nbv.h"
#include "experiments/studies/explore.h"
#include "experiments/studies/extract.h"
#include "experiments/studies/fig_01.h"
#include "experiments/studies/fig_02.h"
#include "experiments/studies/fig_03.h"
#include "experiments/studies/fig_04.h"
#include "experiments/studies/fig_05.h"
#include "experiments/studies/fig_06.h"
#include "experiments/studies/fig_07.h"
#include "experiments/studies/fig_08.h"
#include "experiments/studies/fig_09.h"
#include "experiments/studies/fig_10.h"
#include "experiments/studies/fig_11.h"
#include "experiments/studies/fig_12.h"
#include "experiments/studies/fig_13.h"
#include "experiments/studies/map.h"
#include "experiments/studies/optimize.h"
#include "experiments/studies/plan.h"
#include "experiments/studies/planning_time.h"
#include "experiments/studies/posegraph_benchmark.h"
#include "experiments/studies/register.h"
#include "experiments/studies/simulate.h"
#include "experiments/studies/table_1.h"
#include "experiments/studies/walking_persons.h"

namespace ariadne::experiments {
namespace {

/// A study from its options, the function that throws where its input is wrong, and the one that runs it.
template <typename Options, typename Check, typename Run>
Study MakeStudy(const std::string& name, const std::string& summary, Check check, Run run) {
  const auto config = [name](const Options& options) {
    return fmt::format("experiment: {}\n{}", name, WriteOptions(options));
  };
  Study study{name, summary, DescribeOptions<Options>, {}, {}, {}, {}};
  study.defaults = [config] { return config(Options()); };
  study.resolve = [config](const OptionEntries& entries) { return config(ReadOptions<Options>(entries)); };
  study.check_input = [check](const OptionEntries& entries) { check(ReadOptions<Options>(entries)); };
  study.run = [config, run](const OptionEntries& entries, const RunDirectory& directory,
                            ProgressDisplay& progress) {
    const auto options = ReadOptions<Options>(entries);
    directory.WriteConfig(config(options));
    return StudyResult{run(options, directory, progress)};
  };
  return study;
}

/// A study of scans.
template <typename Options, typename Run>
Study MakeStudy(const std::string& name, const std::string& summary, Run run) {
  const auto check = [](const Options& options) { const ScanSource source(options.input); };
  return MakeStudy<Options>(name, summary, check, run);
}

StudyResult RunRegisterStudy(const RegisterOptions& options, const RunDirectory& run,
                             ProgressDisplay& progress) {
  const RegisterSummary summary = RunRegister(options, run, progress);
  return {fmt::format("{}\n{}\n{}\n", ToText(summary.table), summary.residuals, summary.errors),
          summary.Problem()};
}

StudyResult RunOptimizeStudy(const OptimizeOptions& options, const RunDirectory& run,
                             ProgressDisplay& progress) {
  const OptimizeSummary summary = RunOptimize(options, run, progress);
  return {summary.text, summary.problem};
}

StudyResult RunPosegraphBenchmarkStudy(const PosegraphBenchmarkOptions& options, const RunDirectory& run,
                                       ProgressDisplay& progress) {
  const PosegraphBenchmarkSummary summary = RunPosegraphBenchmark(options, run, progress);
  return {summary.text, summary.problem};
}

}  // namespace

const std::vector<Study>& AllStudies() {
  static const std::vector<Study> kStudies{
      MakeStudy<RegisterOptions>("register", "a folder of scans into one map", RunRegisterStudy),
      MakeStudy<ExploreStudyOptions>(
          "explore", "a building that the robot was never told", CheckExplore,
          [](const ExploreStudyOptions& options, const RunDirectory& run, ProgressDisplay& progress) {
            return RunExplore(options, run, progress);
          }),
      MakeStudy<OptimizeOptions>("optimize", "a pose graph into its best poses", CheckOptimizeInput,
                                 RunOptimizeStudy),
      MakeStudy<PosegraphBenchmarkOptions>("posegraph_benchmark",
                                           "the public pose graphs: minima and certificates",
                                           CheckPosegraphBenchmark, RunPosegraphBenchmarkStudy),
      MakeStudy<ExtractOptions>("extract", "lines, surfaces and objects of each scan", RunExtract),
      MakeStudy<MapStudyOptions>("map", "the scans of a run into a model of the building", CheckMapInput,
                                 RunMap),
      MakeStudy<PlanStudyOptions>("plan", "where to scan next, from the scans of a run", CheckPlanInput,
                                  RunPlan),
      MakeStudy<SimulateOptions>("simulate", "a data set with its truth, from a simulated robot",
                                 RunSimulate),
      MakeStudy<Table1Options>("table_1", "ICP with all and reduced points, brute force and k-d tree",
                               RunTable1),
      MakeStudy<Fig01Options>(
          "fig_01", "the robot and its scanner, rendered", [](const Fig01Options&) {}, RunFig01),
      MakeStudy<Fig02Options>("fig_02", "a scan from its reflectance to lines, surfaces and objects",
                              RunFig02),
      MakeStudy<Fig03Options>("fig_03", "two scans before, during and after ICP", RunFig03),
      MakeStudy<Fig04Options>("fig_04", "scans of a corridor by each way of matching", RunFig04),
      MakeStudy<Fig05Options>(
          "fig_05", "the edge points and reduced points of a scan beside all of its points", RunFig05),
      MakeStudy<Fig06Options>("fig_06", "one step of planning, from points to the next view", RunFig06),
      MakeStudy<Fig07Options>("fig_07", "two labelled polygons and their union", RunFig07),
      MakeStudy<Fig08Options>("fig_08", "the frames and quantities of the control law", CheckFig08,
                              RunFig08),
      MakeStudy<Fig09Options>("fig_09", "paths of the controller to one pose from many", CheckFig09,
                              RunFig09),
      MakeStudy<Fig10Options>("fig_10", "trajectories to next views, around boxes of objects", RunFig10),
      MakeStudy<Fig11Options>("fig_11", "the octree of a scan at several depths", RunFig11),
      MakeStudy<Fig12Options>("fig_12", "an exploration: path and stops, mesh, boxes around objects",
                              CheckFig12, RunFig12),
      MakeStudy<Fig13Options>("fig_13", "the first scans of an exploration, and what each was planned in",
                              CheckFig13, RunFig13),
      MakeStudy<AblationMatchingOptions>("ablation_matching",
                                         "ways of matching many scans, over many simulated tours",
                                         RunAblationMatching),
      MakeStudy<AblationFeaturesOptions>(
          "ablation_features", "detectors of lines and surfaces: against truth, and on real sweeps",
          [](const AblationFeaturesOptions&) {}, RunAblationFeatures),
      MakeStudy<AblationGraphOptions>("ablation_graph",
                                      "pose graphs with wrong closures, from other starts, of other sizes",
                                      CheckAblationGraph, RunAblationGraph),
      MakeStudy<AblationNbvOptions>("ablation_nbv",
                                    "policies and parameters of the view planner, on known floors",
                                    CheckAblationNbv, RunAblationNbv),
      MakeStudy<AblationMissionOptions>("ablation_mission",
                                        "whole missions in buildings, as configured and otherwise",
                                        CheckAblationMission, RunAblationMission),
      MakeStudy<WalkingPersonsOptions>("walking_persons", "a robot whose way persons cross",
                                       CheckWalkingPersons, RunWalkingPersons),
      MakeStudy<AblationControlOptions>("ablation_control",
                                        "the paper's controller, its fallbacks, and pure pursuit",
                                        CheckAblationControl, RunAblationControl),
      MakeStudy<PlanningTimeOptions>("planning_time",
                                     "time to choose the next view, over candidates and edges",
                                     CheckPlanningTime, RunPlanningTime)};
  return kStudies;
}

const Study& FindStudy(const std::string& name, const std::string& where) {
  const std::vector<Study>& studies = AllStudies();
  const auto found =
      std::find_if(studies.begin(), studies.end(), [&](const Study& s) { return s.name == name; });
  if (found != studies.end()) return *found;
  std::vector<std::string> names;
  for (const Study& study : studies) names.push_back(study.name);
  Fail("{}{}there is no experiment '{}'; there are {}", where, where.empty() ? "" : ": ", name,
       fmt::join(names, ", "));
}

}  // namespace ariadne::experiments
