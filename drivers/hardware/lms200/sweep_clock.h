#pragma once

#include <optional>

#include "slam/base/options.h"

namespace ariadne::drivers::lms200 {

struct SweepClockOptions {
  double tolerance = 0.25;
  double drift = 0.001;
  int confirmations = 2;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit(
        "tolerance", self.tolerance, Unit(""), Range{0.01, 0.45},
        "how far an arrival may be from the mirror's beat, in periods; later ones may be of another turn");
    visit("drift", self.drift, Unit(""), Range{0.0, 0.05},
          "of the mirror's period against the nominal one");
    visit("confirmations", self.confirmations, Unit(""), Range{1, 100},
          "arrivals that agree before one is believed, at the start and after a loss");
  }
};

/// When sweeps ended, by the mirror's beat instead of by when their telegrams arrived: the mirror turns
/// evenly, and lines only delay. The beat is what the earliest arrivals fit; it follows later ones by no
/// more than the drift of the mirror. An arrival has a time if it fits the beat, and if as many sweeps have
/// arrived as the mirror has made: then none is missing, and none can be of an earlier turn. After a loss
/// some must agree on how many are missing. A line that is slower than the mirror leaves sweeps out, always
/// as many.
class SweepClock {
 public:
  /// `period` [s] from one sweep of the mirror to the next.
  explicit SweepClock(double period, const SweepClockOptions& options = {})
      : period_(period), options_(options) {}

  /// When the sweep ended whose telegram would have left the device at `observed` if nothing had delayed it
  /// [s]; none if that is open. One that has `waited` until somebody listened has a time only where it is
  /// counted: when it came nobody knows, and many that wait look like a beat of their own.
  std::optional<double> EndOf(double observed, bool waited = false);

  /// Forgets the beat, because the device may have another one now.
  void Reset();

 private:
  void Follow(double observed);
  std::optional<double> TakeUpBeat();
  bool IsCounted(double turns, bool waited);

  double period_;
  SweepClockOptions options_;

  // The latest arrivals at even distances:
  bool has_previous_ = false;
  double previous_ = 0.0;  // observed [s]
  int confirmed_ = 0;      // even distances so far
  double distance_ = 0.0;  // in periods
  double chain_ = 0.0;     // the end that the earliest of them tells [s]

  // What is believed:
  bool has_beat_ = false;
  double beat_ = 0.0;     // the end of the last sweep with a time [s]
  double usual_ = 1.0;    // distance of the sweeps that are sent, in periods
  double arrived_ = 0.0;  // sweeps since then
  double missing_ = 0.0;  // of them
  int agreed_ = 0;        // arrivals that say so, after the first one
};

}  // namespace ariadne::drivers::lms200
