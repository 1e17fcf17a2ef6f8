#include "experiments/studies/recorded_decisions.h"

#include <fmt/format.h>

#include <initializer_list>

#include "drivers/replay/compared_robot.h"
#include "slam/io/file.h"

namespace ariadne::experiments {
namespace {

/// Of a value that may be a whole path.
std::string Shortened(const Json& value) {
  constexpr std::size_t kShown = 160;
  const std::string text = value.dump();
  return text.size() <= kShown ? text : text.substr(0, kShown) + "...";
}

/// Values as they come back from a file.
void RequireSame(const std::string& file, const Json& recorded, const Json& now,
                 std::initializer_list<const char*> keys) {
  const Json as_written = Json::parse(now.dump());
  for (const char* key : keys) {
    const Json was = recorded.value(key, Json());
    const Json is = as_written.value(key, Json());
    if (was == is) continue;
    throw drivers::DepartedFromLog(
        fmt::format("{}: {} was recorded as {}; now {}", file, key, Shortened(was), Shortened(is)));
  }
}

}  // namespace

/// Null where there is no such file.
Json RecordedDecisions::Recorded(const std::string& file) const {
  const std::filesystem::path path = run_ / file;
  if (!std::filesystem::exists(path)) return nullptr;
  std::ifstream in = slam::OpenForReading(path);
  Json json = Json::parse(in, nullptr, false);
  if (!json.is_object()) Fail("{}: cannot be read; it is no JSON of a run", path.string());
  return json;
}

void RecordedDecisions::CompareStop(const ExploredStep& step) const {
  const std::string file = StepName(step.index) + ".json";
  const Json recorded = Recorded(file);
  if (recorded.is_null()) return;
  RequireSame(file, recorded, ToJson(step), {"scan", "registered", "stops_m_rad", "driven_m"});
}

/// A run that was ended before it drove has the step without its plan.
void RecordedDecisions::ComparePlan(const ExploredStep& step) const {
  const std::string file = StepName(step.index) + ".json";
  const Json recorded = Recorded(file);
  if (recorded.is_null() || recorded.value("planned_m_rad", Json()).empty()) return;
  RequireSame(file, recorded, ToJson(step),
              {"next_view", "planned_m_rad", "leg_only", "of_disc", "area_m_seen"});
}

void RecordedDecisions::CompareEnd(const MissionResult& result) const {
  const Json recorded = Recorded("metrics.json");
  if (recorded.is_null()) return;
  const Json now{{"end", Describe(result.end)}, {"scans", result.scans.size()}, {"time_s", result.time}};
  RequireSame("metrics.json", recorded, now, {"end", "scans", "time_s"});
}

}  // namespace ariadne::experiments
