#pragma once

#include <algorithm>
#include <deque>

namespace ariadne::drivers {

/// Where something that moves was within the last second: who is coupled to it may ask for times that have
/// passed. It went straight from one remembered place to the next.
class PositionMemory {
 public:
  /// Called after each step, in ascending times [s]. What stood still is one span.
  void Remember(double time, double position) {
    constexpr double kRemembered = 1.0;  // [s]
    const std::size_t count = past_.size();
    const bool stands =
        count >= 2 && past_[count - 1].position == position && past_[count - 2].position == position;
    if (stands) past_.pop_back();
    past_.push_back({time, position});
    while (past_.size() > 2 && past_[1].time < time - kRemembered) past_.pop_front();
  }

  /// `now` is where it is after the last step.
  double At(double time, double now) const {
    const auto after = std::lower_bound(past_.begin(), past_.end(), time,
                                        [](const Past& past, double t) { return past.time < t; });
    if (after == past_.end()) return now;
    if (after == past_.begin()) return after->position;
    const Past& before = *(after - 1);
    const double share = (time - before.time) / (after->time - before.time);
    return before.position + share * (after->position - before.position);
  }

 private:
  struct Past {
    double time;  // [s]
    double position;
  };
  std::deque<Past> past_;
};

}  // namespace ariadne::drivers
