#include "experiments/studies/register.h"

#include <fmt/format.h>

#include <optional>

#include "experiments/config/options_io.h"
#include "experiments/report/viewer.h"
#include "experiments/run/manifest.h"
#include "experiments/run/run_page.h"
#include "experiments/studies/register_log.h"
#include "experiments/studies/register_output.h"
#include "experiments/studies/register_report.h"

namespace ariadne::experiments {
namespace {

constexpr const char* kCheckpoint = "checkpoint.json";

/// A registration under way.
struct State {
  slam::Mapper mapper;
  RegisterLog log;
  Json timing = {{"read_s", Json::array()}, {"match_s", Json::array()}};
};

/// The state of the last checkpoint, or that of a new run.
State Start(const RegisterOptions& options, const ScanSource& source, const RunDirectory& run) {
  State state{slam::Mapper(options.mapper), {}};
  if (!std::filesystem::exists(run.path() / kCheckpoint)) return state;
  const Json checkpoint = Json::parse(run.ReadText(kCheckpoint));
  state.log = RegisterLogFromJson(checkpoint.at("log"));
  state.timing = checkpoint.at("timing");
  for (std::size_t i = 0; i < state.log.registered.size(); ++i) {
    state.mapper.RestoreScan(source.Read(i), state.log.T_map_laser[i], state.log.registered[i]);
  }
  state.mapper.RestoreGraph(state.log.graph);
  return state;
}

/// Reads and registers one scan, and makes the checkpoint.
void AddScan(State& state, const ScanSource& source, const RunDirectory& run, ProgressDisplay& progress) {
  const std::size_t i = state.log.registered.size();
  const std::string label = fmt::format("{} ({} of {})", source.name(i), i + 1, source.size());
  const Stopwatch reading;
  const slam::PosedCloud scan = source.Read(i);
  const double read_s = reading.Seconds();
  const Stopwatch matching;
  int iteration = 0;
  const slam::MatchResult result = state.mapper.AddScan(scan, [&](const slam::MatchProgress& p) {
    progress.Show(fmt::format("{}: scan {}, {} queued, iteration {}, rms {:.4f} m, {} pairs, {}", label,
                              p.scan, p.queued, ++iteration, p.iteration->rms, p.iteration->pairs,
                              progress.Eta(static_cast<double>(i) / static_cast<double>(source.size()))));
  });
  state.timing["read_s"].push_back(read_s);
  state.timing["match_s"].push_back(matching.Seconds());
  const auto [min_range, max_range] = state.mapper.options().scan;
  state.log.Add(state.mapper, result, slam::WithinRange(scan.cloud_laser, min_range, max_range).size(),
                !scan.cloud_laser.reflectance.empty());
  run.WriteJson(kCheckpoint, {{"log", ToJson(state.log)}, {"timing", state.timing}});
  run.WriteProgress("running", i + 1, source.size());
  progress.Keep(
      fmt::format("{}: {}{}", label, result.registered ? "" : "NOT REGISTERED: ", result.message));
}

/// Moves the scans once more; a run that is killed here does it again.
void Finish(State& state, ProgressDisplay& progress) {
  const Stopwatch finishing;
  const slam::MatchResult result = state.mapper.Finish();
  state.timing["finish_s"] = finishing.Seconds();
  state.log.AddFinish(state.mapper, result);
  if (!result.message.empty()) progress.Keep(result.message);
}

}  // namespace

std::string RegisterConfig(const RegisterOptions& options) {
  return "experiment: register\n" + WriteOptions(options);
}

RegisterSummary RunRegister(const RegisterOptions& options, const RunDirectory& run,
                            ProgressDisplay& progress) {
  const ScanSource source(options.input);
  for (const std::string& note : source.notes()) progress.Keep(note);
  run.WriteConfig(RegisterConfig(options));
  State state = Start(options, source, run);
  WriteManifest(run, source.Files(), state.log.registered.size());
  run.WriteProgress("running", state.log.registered.size(), source.size());
  while (state.log.registered.size() < source.size()) AddScan(state, source, run, progress);
  Finish(state, progress);

  const Stopwatch writing;
  const std::vector<slam::PosedCloud> shown =
      WriteRegisterOutput(options, source, state.log, run, progress);
  RegisterSummary summary = ReportRegistration(options, source, state.mapper, state.log,
                                               state.timing.at("match_s").get<std::vector<double>>(), run);
  state.timing["write_s"] = writing.Seconds();
  run.WriteJson("timing.json", state.timing);
  std::filesystem::remove(run.path() / kCheckpoint);
  std::optional<PageSection> view;
  if (!shown.empty()) view = ViewerSection(SceneOf(shown));
  FinishRun(run, fmt::format("Registration of {} scans", source.size()), source.size(), view);
  return summary;
}

}  // namespace ariadne::experiments
