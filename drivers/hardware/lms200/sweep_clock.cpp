#include "drivers/hardware/lms200/sweep_clock.h"

#include <algorithm>
#include <cmath>

namespace ariadne::drivers::lms200 {

void SweepClock::Reset() { *this = SweepClock(period_, options_); }

/// Whether the distance to the previous arrival is one of whole periods, and the same as before; and the
/// beat of such a chain, which is that of its earliest arrival.
void SweepClock::Confirm(double observed) {
  const double periods = (observed - previous_) / period_;
  const double whole = std::round(periods);
  const bool even = whole >= 1.0 && std::abs(periods - whole) <= options_.tolerance;
  const bool goes_on = even && confirmed_ > 0 && whole == distance_;
  const double predicted = (goes_on ? chain_ : previous_) + whole * period_;
  confirmed_ = goes_on ? confirmed_ + 1 : (even ? 1 : 0);
  chain_ = even ? std::min(predicted, observed) : observed;
  distance_ = whole;
  previous_ = observed;
}

std::optional<double> SweepClock::EndOf(double observed) {
  if (!has_previous_) {
    has_previous_ = true;
    previous_ = observed;
    return std::nullopt;
  }
  Confirm(observed);
  // Without a chain, an early arrival may be a late one of the turn before.
  if (confirmed_ < options_.confirmations) return std::nullopt;
  if (!has_beat_) {
    has_beat_ = true;
    usual_ = distance_;
    beat_ = chain_;
    return beat_;
  }
  // A loss and a delay together look like another distance; a slower line looks so for longer.
  if (distance_ != usual_ && confirmed_ < 3 * options_.confirmations) return std::nullopt;
  usual_ = distance_;
  const double turns = std::round((observed - beat_) / period_);
  const double beat = beat_ + turns * period_;
  const double late = observed - beat;
  if (std::abs(late) <= options_.tolerance * period_) {
    beat_ = beat + std::min(late, options_.drift * turns * period_);
    return beat_;
  }
  // Another beat, if it goes on: of a device that was reset.
  if (confirmed_ < 2 * options_.confirmations) return std::nullopt;
  beat_ = chain_;
  return beat_;
}

}  // namespace ariadne::drivers::lms200
