#include "drivers/hardware/robot/tilt_track.h"

#include <algorithm>

#include "slam/base/error.h"

namespace ariadne::drivers {

void TiltTrack::Add(double time, double angle) {
  if (!samples_.empty() && !(time > samples_.back().time)) return;  // the same moment once more
  samples_.push_back({time, angle});
}

/// Least squares over the samples of the window, the two next to `time` among them; before the first and
/// after the last one, what the nearest ones say.
Tilt TiltTrack::At(double time) const {
  if (samples_.size() < 2) Fail("the servo's position was measured {} times only", samples_.size());
  const auto later = [](double t, const Sample& sample) { return t < sample.time; };
  const auto earlier = [](const Sample& sample, double t) { return sample.time < t; };
  const auto next = std::upper_bound(samples_.begin() + 1, samples_.end() - 1, time, later);
  const auto first =
      std::min(next - 1, std::lower_bound(samples_.begin(), samples_.end(), time - 0.5 * window_, earlier));
  const auto end =
      std::max(next + 1, std::upper_bound(samples_.begin(), samples_.end(), time + 0.5 * window_, later));
  double count = 0.0, mean_time = 0.0, mean_angle = 0.0;
  for (auto sample = first; sample != end; ++sample) {
    count += 1.0;
    mean_time += sample->time - time;
    mean_angle += sample->angle;
  }
  mean_time /= count;
  mean_angle /= count;
  double square = 0.0, product = 0.0;
  for (auto sample = first; sample != end; ++sample) {
    const double t = sample->time - time - mean_time;
    square += t * t;
    product += t * (sample->angle - mean_angle);
  }
  const double rate = product / square;
  return {mean_angle - rate * mean_time, rate};
}

}  // namespace ariadne::drivers
