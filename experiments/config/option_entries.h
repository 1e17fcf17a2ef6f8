#pragma once

#include <optional>
#include <string>
#include <vector>

namespace ariadne::experiments {

/// One value that somebody has written down, and where.
struct OptionEntry {
  std::string key;    // "icp.max_distance"
  std::string value;  // as written
  std::string where;  // "table_1.yaml:12", or "--set icp.max_distance=0.75"
};

/// All values of a config file and of the command line. Later ones replace earlier ones.
class OptionEntries {
 public:
  /// Reads a YAML file of nested maps with scalars as leaves. A repeated key, a list, or text that is not
  /// YAML is an Error with file and line.
  static OptionEntries FromFile(const std::string& path);
  static OptionEntries FromText(const std::string& text, const std::string& name);

  /// Adds "key=value" from the command line.
  void Set(const std::string& assignment);

  /// The value of a key, removed from the entries.
  std::optional<OptionEntry> Take(const std::string& key);

  const std::vector<OptionEntry>& entries() const { return entries_; }

 private:
  void Add(OptionEntry entry);
  std::vector<OptionEntry> entries_;
};

}  // namespace ariadne::experiments
