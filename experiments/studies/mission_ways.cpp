#include "experiments/studies/mission_ways.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "slam/base/numbers.h"

namespace ariadne::experiments {
namespace {

template <typename Enum>
Enum ByName(const std::string& list, const std::string& name) {
  const auto& names = EnumNames<Enum>::value;
  const auto found = std::ranges::find(names, name);
  if (found == names.end())
    Fail("variants.{}: there is no \"{}\"; there are {}", list, name, fmt::join(names, ", "));
  return static_cast<Enum>(found - names.begin());
}

void SetPlanner(const std::string& name, int paper_scans, MissionOptions& mission) {
  if (name == "paper") {
    mission.planner = PaperRobotPlannerOptions(mission.planner);
    mission.limits.max_scans = std::min(mission.limits.max_scans, paper_scans);
  } else {
    mission.planner.policy = ByName<planning::ViewPolicy>("planners", name);
  }
}

void SetDrive(const std::string& name, MissionOptions& mission) {
  if (name == "odometry") {
    mission.drive.localize.enabled = false;
  } else {
    mission.drive_by = ByName<DriveBy>("drives", name);
  }
}

void ScaleWheelErrors(double factor, drivers::SimulatedRobotOptions& robot) {
  robot.base.wheels.radius_spread *= factor;
  robot.base.wheels.track_spread *= factor;
  robot.base.wheels.slip *= factor;
}

void SetRobot(const std::string& name, ExploringRobotOptions& robot) {
  if (name == "without_safety") {
    robot.safety.installed = false;
  } else if (name == "emulated") {
    robot.kind = RobotKind::kEmulated;
  } else {
    Fail("variants.robots: there is no \"{}\"; there are emulated, without_safety", name);
  }
}

std::vector<double> ListedNumbers(const std::string& text, const std::string& name) {
  return ListedNames(text).empty() ? std::vector<double>{} : ParseNumbers(text, "variants." + name);
}

}  // namespace

std::vector<std::string> ListedNames(const std::string& text) {
  std::vector<std::string> names;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) {
    const auto first = part.find_first_not_of(' ');
    if (first == std::string::npos) continue;
    names.push_back(part.substr(first, part.find_last_not_of(' ') - first + 1));
  }
  return names;
}

std::vector<MissionVariant> MissionVariants(const MissionOptions& mission,
                                            const drivers::SimulatedRobotOptions& robot,
                                            const MissionVariantOptions& variants) {
  std::vector<MissionVariant> ways{{"default", mission, {robot}}};
  const auto add = [&](const std::string& name) -> MissionVariant& {
    return ways.emplace_back(MissionVariant{name, mission, {robot}});
  };
  if (variants.paper) {
    MissionOptions& paper = add("2003").mission;
    paper = PaperMissionOptions();
    paper.limits = mission.limits;
    paper.limits.max_scans = std::min(paper.limits.max_scans, variants.paper_scans);
  }
  for (const std::string& name : ListedNames(variants.matching))
    add("matching " + name).mission.mapper.registration.method =
        ByName<slam::MatchMethod>("matching", name);
  for (const std::string& name : ListedNames(variants.planners))
    SetPlanner(name, variants.paper_scans, add("planner " + name).mission);
  for (const double overlap : ListedNumbers(variants.overlaps, "overlaps"))
    add(fmt::format("overlap {}", overlap)).mission.planner.min_overlap = overlap;
  for (std::string heights : ListedNames(variants.slices)) {
    MissionVariant& way = add("slices " + heights);
    std::ranges::replace(heights, ' ', ',');
    ParseNumbers(heights, "variants.slices");
    way.mission.heights = heights;
  }
  for (const std::string& name : ListedNames(variants.drives)) SetDrive(name, add("drive " + name).mission);
  for (const double factor : ListedNumbers(variants.noises, "noises"))
    ScaleWheelErrors(factor, add(fmt::format("wheels' errors x {}", factor)).robot);
  for (const std::string& name : ListedNames(variants.robots)) SetRobot(name, add("robot " + name).robot);
  return ways;
}

}  // namespace ariadne::experiments
