#include "drivers/simulated/floor_plan.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "slam/base/error.h"

namespace ariadne::drivers {
namespace {

using nlohmann::json;
constexpr double kFarthest = 1e5;  // no building is larger [m]

const json& Member(const json& parent, const char* key, json::value_t type, const std::string& file) {
  const auto found = parent.find(key);
  if (found == parent.end()) Fail("{}: the key \"{}\" is missing", file, key);
  if (found->type() != type)
    Fail("{}: \"{}\" must be {}, not {}", file, key, json(type).type_name(), found->type_name());
  return *found;
}

/// So many finite numbers; `place` names them in errors.
Eigen::VectorXd Numbers(const json& value, Eigen::Index count, const std::string& file,
                        const std::string& place) {
  if (!value.is_array() || static_cast<Eigen::Index>(value.size()) != count) {
    Fail("{}: {} needs {} numbers", file, place, count);
  }
  Eigen::VectorXd numbers(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const json& item = value[static_cast<std::size_t>(i)];
    if (!item.is_number())
      Fail("{}: {} needs {} numbers, but one is {}", file, place, count, item.type_name());
    numbers[i] = item.get<double>();
    if (!(std::abs(numbers[i]) <= kFarthest)) Fail("{}: {} is {} m away", file, place, numbers[i]);
  }
  return numbers;
}

std::vector<PlanSpace> ReadSpaces(const json& root, const std::string& file) {
  std::vector<PlanSpace> spaces;
  if (!root.contains("spaces")) return spaces;
  for (const json& item : Member(root, "spaces", json::value_t::array, file)) {
    const std::string place = fmt::format("spaces[{}]", spaces.size());
    if (!item.is_object() || !item.contains("polygon") || !item["polygon"].is_array()) {
      Fail("{}: {} needs a polygon", file, place);
    }
    PlanSpace space;
    if (item.contains("label") && item["label"].is_string()) space.label = item["label"];
    for (const json& corner : item["polygon"])
      space.outline.emplace_back(Numbers(corner, 2, file, place + ".polygon"));
    spaces.push_back(std::move(space));
  }
  return spaces;
}

json ParseJson(const std::string& text, const std::string& file) {
  try {
    return json::parse(text);
  } catch (const json::parse_error& e) {
    const std::string_view before = std::string_view(text).substr(0, e.byte > 0 ? e.byte - 1 : 0);
    const auto line = std::count(before.begin(), before.end(), '\n') + 1;
    const std::size_t last = before.rfind('\n');
    const std::size_t column = before.size() - (last == std::string_view::npos ? 0 : last + 1) + 1;
    Fail("{}:{}:{}: not valid JSON", file, line, column);
  }
}

}  // namespace

FloorPlan ParseFloorPlan(const std::string& text, const std::string& file) {
  const json root = ParseJson(text, file);
  if (!root.is_object()) Fail("{}: a floor plan is a JSON object with \"walls\"", file);
  if (root.contains("unit") && root["unit"] != "m")
    Fail("{}: the unit of a floor plan is \"m\", not {}", file, root["unit"].dump());
  FloorPlan plan;
  if (root.contains("name") && root["name"].is_string()) plan.name = root["name"];
  plan.start = Numbers(Member(root, "start", json::value_t::array, file), 2, file, "start");
  for (const json& item : Member(root, "walls", json::value_t::array, file)) {
    const Eigen::VectorXd wall = Numbers(item, 4, file, fmt::format("walls[{}]", plan.walls.size()));
    plan.walls.push_back({wall.head<2>(), wall.tail<2>()});
  }
  if (root.contains("doors")) {
    for (const json& item : Member(root, "doors", json::value_t::array, file)) {
      plan.doors.emplace_back(Numbers(item, 2, file, fmt::format("doors[{}]", plan.doors.size())));
    }
  }
  plan.spaces = ReadSpaces(root, file);
  return plan;
}

}  // namespace ariadne::drivers
