#pragma once

#include <functional>
#include <string>
#include <utility>

namespace ariadne::drivers {

/// An emergency stop that latches: once a source has given a reason it stays pressed, whatever the source
/// says then, until it is released by a person. It knows no keys, signals or terminals; who does gives the
/// source, which is asked often and says nothing as long as all is well.
class EmergencyStop {
 public:
  using Source = std::function<std::string()>;  // the reason as a clause, or empty

  explicit EmergencyStop(Source source = {}) : source_(std::move(source)) {}

  void Press(const std::string& reason) {
    if (reason_.empty()) reason_ = reason.empty() ? "the emergency stop was pressed" : reason;
  }

  /// Asks the source.
  bool IsPressed() {
    if (reason_.empty() && source_) {
      const std::string reason = source_();
      if (!reason.empty()) Press(reason);
    }
    return !reason_.empty();
  }

  /// Empty unless pressed.
  const std::string& reason() const { return reason_; }

  /// It stays pressed where the source still has a reason.
  void Release() { reason_.clear(); }

 private:
  Source source_;
  std::string reason_;
};

}  // namespace ariadne::drivers
