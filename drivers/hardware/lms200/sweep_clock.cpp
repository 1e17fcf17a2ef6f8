#include "drivers/hardware/lms200/sweep_clock.h"

#include <algorithm>
#include <cmath>

namespace ariadne::drivers::lms200 {

void SweepClock::Reset() { *this = SweepClock(period_, options_); }

/// Arrivals at the same distance of whole periods make a chain. Its beat is that of the earliest one.
void SweepClock::Follow(double observed) {
  const double periods = (observed - previous_) / period_;
  const double whole = std::round(periods);
  const bool even = has_previous_ && whole >= 1.0 && std::abs(periods - whole) <= options_.tolerance;
  const bool goes_on = even && confirmed_ > 0 && whole == distance_;
  const double predicted = (goes_on ? chain_ : previous_) + whole * period_;
  confirmed_ = goes_on ? confirmed_ + 1 : (even ? 1 : 0);
  chain_ = even ? std::min(predicted, observed) : observed;
  distance_ = whole;
  previous_ = observed;
  has_previous_ = true;
}

std::optional<double> SweepClock::TakeUpBeat() {
  has_beat_ = true;
  beat_ = chain_;
  usual_ = distance_;
  arrived_ = 0.0;
  agreed_ = 0;
  return beat_;
}

/// Whether it is known that so many turns have passed. A delay makes them more than sweeps have arrived,
/// and so does a loss: only that stays the same. Over a long time the mirror's drift makes turns as well,
/// and hides what is missing of those that have waited.
bool SweepClock::IsCounted(double turns, bool waited) {
  const double missing = turns - arrived_ * usual_;
  if (waited) return missing == 0.0 && turns * options_.drift < 0.5;
  if (missing == 0.0) return true;
  agreed_ = missing == missing_ ? agreed_ + 1 : 0;
  missing_ = missing;
  return agreed_ >= options_.confirmations;
}

std::optional<double> SweepClock::EndOf(double observed, bool waited) {
  if (!waited) Follow(observed);
  if (!has_beat_) return waited || confirmed_ < options_.confirmations ? std::nullopt : TakeUpBeat();
  ++arrived_;
  const double turns = std::round((observed - beat_) / period_);
  const double late = observed - (beat_ + turns * period_);
  if (std::abs(late) <= options_.tolerance * period_ && turns >= 1.0 && IsCounted(turns, waited)) {
    beat_ = observed - late + std::min(late, options_.drift * turns * period_);
    arrived_ = 0.0;
    agreed_ = 0;
    return beat_;
  }
  // What goes on for long is another beat, of a device that was reset, or of a slower line.
  return waited || confirmed_ < 3 * options_.confirmations ? std::nullopt : TakeUpBeat();
}

}  // namespace ariadne::drivers::lms200
