#include "experiments/config/option_entries.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>

#include "slam/base/error.h"

namespace ariadne::experiments {
namespace {

std::string Where(const std::string& name, const YAML::Mark& mark) {
  return fmt::format("{}:{}", name, mark.line + 1);
}

constexpr std::size_t kMaxDepth = 16;  // an alias within its own anchor would go on for ever

/// Appends the leaves below a node, under their dotted keys.
void Flatten(const YAML::Node& node, const std::string& prefix, const std::string& name,
             std::vector<OptionEntry>& entries) {
  for (const auto& pair : node) {
    const std::string key = prefix + pair.first.Scalar();
    const std::string where = Where(name, pair.first.Mark());
    if (static_cast<std::size_t>(std::count(key.begin(), key.end(), '.')) > kMaxDepth) {
      Fail("{}: {} is nested too deeply; no option is", where, key);
    }
    const auto same = [&](const OptionEntry& entry) {
      return entry.key == key || entry.key.starts_with(key + ".");
    };
    const auto earlier = std::find_if(entries.begin(), entries.end(), same);
    if (earlier != entries.end())
      Fail("{}: the key {} is repeated; it stands already at {}", where, key, earlier->where);
    if (pair.second.IsMap()) {
      Flatten(pair.second, key + ".", name, entries);
    } else if (pair.second.IsScalar()) {
      entries.push_back({key, pair.second.Scalar(), where});
    } else {
      Fail("{}: {} needs a value{}", where, key, pair.second.IsSequence() ? ", not a list" : "");
    }
  }
}

}  // namespace

OptionEntries OptionEntries::FromFile(const std::string& path) {
  std::error_code ignored;  // what cannot be asked for cannot be opened either
  if (std::filesystem::is_directory(path, ignored)) Fail("{}: is a folder, not a config", path);
  std::ifstream in(path);
  if (!in) Fail("{}: cannot open the config", path);
  std::stringstream text;
  text << in.rdbuf();
  if (in.bad()) Fail("{}: cannot read the config", path);
  return FromText(text.str(), path);
}

OptionEntries OptionEntries::FromText(const std::string& text, const std::string& name) {
  OptionEntries entries;
  try {
    const std::vector<YAML::Node> documents = YAML::LoadAll(text);
    if (documents.size() > 1) {
      Fail("{}: a config is one YAML document; the file holds {}", Where(name, documents[1].Mark()),
           documents.size());
    }
    if (documents.empty() || documents.front().IsNull()) return entries;
    const YAML::Node& root = documents.front();
    if (!root.IsMap()) Fail("{}: a config is a map of keys to values", Where(name, root.Mark()));
    Flatten(root, "", name, entries.entries_);
  } catch (const YAML::Exception& e) {
    Fail("{}: not valid YAML: {}", Where(name, e.mark), e.msg);
  }
  return entries;
}

void OptionEntries::Set(const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == 0 || equals == std::string::npos) {
    Fail("--set {}: expected key=value, as in --set icp.max_distance=0.75", assignment);
  }
  Add({assignment.substr(0, equals), assignment.substr(equals + 1), "--set " + assignment});
}

void OptionEntries::Add(OptionEntry entry) {
  Take(entry.key);
  entries_.push_back(std::move(entry));
}

std::optional<OptionEntry> OptionEntries::Take(const std::string& key) {
  const auto found = std::find_if(entries_.begin(), entries_.end(),
                                  [&](const OptionEntry& entry) { return entry.key == key; });
  if (found == entries_.end()) return std::nullopt;
  OptionEntry entry = std::move(*found);
  entries_.erase(found);
  return entry;
}

}  // namespace ariadne::experiments
