#pragma once

#include <array>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "slam/base/error.h"

namespace ariadne {

/// How options are declared. A struct of options lists its fields once more in a static function
///
///   template <typename Self, typename Visitor>
///   static void Visit(Self& self, Visitor& visit) {
///     visit("max_distance", self.max_distance, Unit("m"), Range{0.001, 100.0}, "why this default");
///     visit("reduce", self.reduce, "a struct of options is a section");
///   }
///
/// and everything that deals with options walks that list: the YAML reader, the command line, the
/// resolved config, the manual, and CheckOptions below.
struct Range {
  double min;  // both included
  double max;
};

struct Unit {
  explicit constexpr Unit(std::string_view symbol) : name(symbol) {}
  std::string_view name;
};

/// The names of an enum's values, in their order; specialize it for an enum that is an option.
template <typename Enum>
struct EnumNames;

template <typename Enum>
std::string_view NameOf(Enum value) {
  return EnumNames<Enum>::value[static_cast<std::size_t>(value)];
}

namespace internal {

class RangeChecker {
 public:
  explicit RangeChecker(std::string section) : section_(std::move(section)) {}

  template <typename T>
  void operator()(std::string_view name, const T& value, Unit unit, Range range, std::string_view) {
    if (value >= range.min && value <= range.max) return;  // false for NaN too
    Fail("{}{} is {} {}, but must be in {} to {}", section_, name, value, unit.name, range.min, range.max);
  }
  template <typename T>
  void operator()(std::string_view name, const T& value, std::string_view) {
    if constexpr (std::is_class_v<T> && !std::is_same_v<T, std::string>) {
      RangeChecker inner(fmt::format("{}{}.", section_, name));
      T::Visit(value, inner);
    }
  }

 private:
  std::string section_;
};

}  // namespace internal

/// Throws an Error that names the first option out of its range.
template <typename Options>
void CheckOptions(const Options& options, std::string section = "") {
  internal::RangeChecker checker(std::move(section));
  Options::Visit(options, checker);
}

}  // namespace ariadne
