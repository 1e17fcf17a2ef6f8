#pragma once

#include <yaml-cpp/yaml.h>

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "slam/base/options.h"

namespace ariadne::drivers {

/// One map of a YAML file while it is read. Each key is taken once; what is missing, of the wrong type, out
/// of its range, repeated or left over is an Error with file and line.
class YamlFields {
 public:
  YamlFields(const YAML::Node& node, std::string file, const std::string& what);

  /// "file:line"
  std::string Where() const { return WhereIs(node_); }
  std::string WhereIs(const YAML::Node& node) const;
  const std::string& file() const { return file_; }

  bool Has(std::string_view key) const;
  double Number(std::string_view key, Range range);
  double NumberOr(double fallback, std::string_view key, Range range);
  std::string Text(std::string_view key);
  std::string TextOr(const std::string& fallback, std::string_view key);
  /// A list of so many numbers.
  Eigen::VectorXd Numbers(std::string_view key, std::size_t least, std::size_t most, Range range);
  /// A list, or a map, of anything; an empty list where the key is missing.
  std::vector<YAML::Node> List(std::string_view key);
  std::vector<std::pair<std::string, YAML::Node>> Entries(std::string_view key);

  /// A value that is not under a key of its own; `what` names it in errors.
  double ToNumber(const YAML::Node& node, std::string_view what, Range range) const;
  Eigen::VectorXd ToNumbers(const YAML::Node& node, std::string_view what, std::size_t least,
                            std::size_t most, Range range) const;

  /// Takes the fields of a struct with a Visit, as many as there are.
  template <typename Shape>
  void Read(Shape& shape) {
    Shape::Visit(shape, *this);
  }
  template <typename T>
  void operator()(std::string_view key, T& value, Unit, Range range, std::string_view) {
    if (Has(key))
      value = static_cast<T>(std::is_integral_v<T> ? Whole(key, range) : Number(key, range));
    else
      Know(key);
  }
  template <typename T>
  void operator()(std::string_view key, T& value, std::string_view) {
    static_assert(std::is_enum_v<T>);
    const auto& names = EnumNames<T>::value;
    if (Has(key))
      value = static_cast<T>(Choice(key, {names.begin(), names.end()}));
    else
      Know(key);
  }

  /// An Error for the first key that nobody has taken.
  void RequireAllTaken() const;

 private:
  void Know(std::string_view key) { known_.emplace_back(key); }
  YAML::Node Take(std::string_view key);
  double Whole(std::string_view key, Range range);
  std::size_t Choice(std::string_view key, const std::vector<std::string_view>& names);

  YAML::Node node_;
  std::string file_;
  std::vector<std::string> known_;
};

/// The name that is spelled most alike; empty without names.
std::string NearestName(std::string_view name, const std::vector<std::string>& names);

}  // namespace ariadne::drivers
