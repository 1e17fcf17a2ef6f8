#pragma once

#include <charconv>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/config/option_entries.h"
#include "slam/base/options.h"

namespace ariadne::experiments {

/// What the manual says of one option.
struct OptionDescription {
  std::string key;
  std::string value;  // the default
  std::string unit;
  std::string range;  // "0.0001 to 1000", or the names of an enum
  std::string reason;
};

/// Conversions between values and the text in files.
double ParseNumber(const OptionEntry& entry);
long long ParseInteger(const OptionEntry& entry);
bool ParseBool(const OptionEntry& entry);
/// The index of the name; an Error lists the names.
std::size_t ParseName(const OptionEntry& entry, const std::string_view* names, std::size_t count);
[[noreturn]] void FailOutOfRange(const OptionEntry& entry, std::string_view unit, Range range);
/// An Error for the first entry that no option has taken, with the nearest key.
void RequireAllTaken(const OptionEntries& entries, const std::vector<std::string>& known_keys);
/// A YAML scalar: quoted where it would be read as something else.
std::string ToYamlScalar(const std::string& text);

template <typename T>
constexpr bool kIsSection = std::is_class_v<T> && !std::is_same_v<T, std::string>;

template <typename T>
std::string ToText(const T& value) {
  if constexpr (std::is_enum_v<T>) {
    return std::string(NameOf(value));
  } else {
    return fmt::format("{}", value);  // doubles: the shortest text that reads back to the same value
  }
}

/// Visits a struct of options and takes the values of the entries.
class OptionReader {
 public:
  explicit OptionReader(OptionEntries& entries) : entries_(entries) {}

  template <typename T>
  void operator()(std::string_view name, T& value, Unit unit, Range range, std::string_view) {
    const std::optional<OptionEntry> entry = Take(name);
    if (!entry) return;
    const double number =
        std::is_integral_v<T> ? static_cast<double>(ParseInteger(*entry)) : ParseNumber(*entry);
    if (!(number >= range.min && number <= range.max)) FailOutOfRange(*entry, unit.name, range);
    value = static_cast<T>(number);
  }

  template <typename T>
  void operator()(std::string_view name, T& value, std::string_view) {
    if constexpr (kIsSection<T>) {
      const std::string outer = prefix_;
      prefix_ += std::string(name) + ".";
      T::Visit(value, *this);
      prefix_ = outer;
    } else if (const std::optional<OptionEntry> entry = Take(name)) {
      if constexpr (std::is_enum_v<T>) {
        value = static_cast<T>(ParseName(*entry, EnumNames<T>::value.data(), EnumNames<T>::value.size()));
      } else if constexpr (std::is_same_v<T, bool>) {
        value = ParseBool(*entry);
      } else {
        value = entry->value;
      }
    }
  }

  const std::vector<std::string>& known_keys() const { return known_keys_; }

 private:
  std::optional<OptionEntry> Take(std::string_view name) {
    known_keys_.push_back(prefix_ + std::string(name));
    return entries_.Take(known_keys_.back());
  }

  OptionEntries& entries_;
  std::string prefix_;
  std::vector<std::string> known_keys_;
};

/// Visits a struct of options and writes its values as YAML.
class OptionWriter {
 public:
  template <typename T>
  void operator()(std::string_view name, const T& value, Unit, Range, std::string_view) {
    Line(name, ToText(value));
  }
  template <typename T>
  void operator()(std::string_view name, const T& value, std::string_view) {
    if constexpr (kIsSection<T>) {
      text_ += fmt::format("{}{}:\n", indent_, name);
      indent_ += "  ";
      T::Visit(value, *this);
      indent_.resize(indent_.size() - 2);
    } else {
      Line(name, ToYamlScalar(ToText(value)));
    }
  }
  const std::string& text() const { return text_; }

 private:
  void Line(std::string_view name, std::string_view value) {
    text_ += fmt::format("{}{}: {}\n", indent_, name, value);
  }
  std::string indent_;
  std::string text_;
};

/// Visits a struct of options and gathers what the manual says.
class OptionDescriber {
 public:
  template <typename T>
  void operator()(std::string_view name, const T& value, Unit unit, Range range, std::string_view reason) {
    descriptions_.push_back({prefix_ + std::string(name), ToText(value), std::string(unit.name),
                             fmt::format("{} to {}", range.min, range.max), std::string(reason)});
  }
  template <typename T>
  void operator()(std::string_view name, const T& value, std::string_view reason) {
    if constexpr (kIsSection<T>) {
      const std::string outer = prefix_;
      prefix_ += std::string(name) + ".";
      T::Visit(value, *this);
      prefix_ = outer;
    } else {
      descriptions_.push_back(
          {prefix_ + std::string(name), ToText(value), "", Names<T>(), std::string(reason)});
    }
  }
  const std::vector<OptionDescription>& descriptions() const { return descriptions_; }

 private:
  template <typename T>
  static std::string Names() {
    if constexpr (std::is_enum_v<T>) return fmt::format("{}", fmt::join(EnumNames<T>::value, ", "));
    return std::is_same_v<T, bool> ? "true, false" : "text";
  }
  std::string prefix_;
  std::vector<OptionDescription> descriptions_;
};

/// Options with the values of the entries where they have one. Unknown keys, wrong types and values out of
/// range are Errors with file and line.
template <typename Options>
Options ReadOptions(OptionEntries entries) {
  Options options;
  OptionReader reader(entries);
  Options::Visit(options, reader);
  RequireAllTaken(entries, reader.known_keys());
  return options;
}

/// All options with their values; ReadOptions reads the same back.
template <typename Options>
std::string WriteOptions(const Options& options) {
  OptionWriter writer;
  Options::Visit(options, writer);
  return writer.text();
}

template <typename Options>
std::vector<OptionDescription> DescribeOptions() {
  const Options defaults;
  OptionDescriber describer;
  Options::Visit(defaults, describer);
  return describer.descriptions();
}

}  // namespace ariadne::experiments
