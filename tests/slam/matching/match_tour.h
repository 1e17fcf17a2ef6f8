#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "slam/matching/match.h"
#include "tests/support/office_scans.h"

namespace ariadne::slam {

/// With which the scans of the tour find their places from 15 cm and 4 degrees away.
inline AlignOptions TourAlignOptions() {
  AlignOptions options;
  options.metric = Metric::kPlaneToPlane;
  options.kernel = RobustKernel::kCauchy;
  options.start_distance = 0.6;
  options.max_distance = 0.25;
  return options;
}

/// Adds the scans of the office tour one by one, from guesses that odometry makes of the last pose: each
/// 15 cm and 4 degrees off. The first scan is the master, at its true pose.
class Tour {
 public:
  Tour(const MatchOptions& match, const AlignOptions& align, MatchCallback on_progress = {})
      : match_(match), align_(align), on_progress_(std::move(on_progress)) {
    map_.scans.push_back(ScanAt(Truth(0), 0));
    map_.scans.back().registered = true;
  }

  std::size_t size() const { return stops_.size(); }
  const std::vector<MapScan>& scans() const { return map_.scans; }
  Pose3 Truth(std::size_t stop) const { return LaserAt(stops_[stop]); }

  /// The scan at the next stop, at its guess.
  MapScan Next() const {
    RandomStream stream = NamedStream(next_, "match_tour/odometry");
    const Pose3 error{ExpSo3(RadFromDeg(4.0) * DrawDirection(stream)), 0.15 * DrawDirection(stream)};
    MapScan scan = ScanAt(Truth(next_), next_);
    scan.T_map_laser = last_pose_ * (Truth(next_ - 1).Inverse() * Truth(next_)) * error;
    return scan;
  }
  MatchResult AddNext() {
    MatchResult result = Add(Next());
    last_pose_ = map_.scans.back().T_map_laser;
    error_of_guess_ = TranslationDistance(guess_, Truth(next_));
    ++next_;
    return result;
  }
  /// What the scanner sees at the first stop, but believed to be at another place.
  MatchResult AddAt(const Pose3& T_map_laser_guess) {
    MapScan scan = ScanAt(Truth(0), 100);
    scan.T_map_laser = T_map_laser_guess;
    return Add(std::move(scan));
  }
  MatchResult Add(MapScan scan) {
    guess_ = scan.T_map_laser;
    map_.scans.push_back(std::move(scan));
    return MatchNewScan(map_, match_, align_, on_progress_);
  }

  MatchResult Finish() { return FinishMatching(map_, match_, align_); }
  ScanMap& map() { return map_; }

  /// Of the scan that was added last.
  const Pose3& guess() const { return guess_; }
  double ErrorOfGuess() const { return error_of_guess_; }

 private:
  MatchOptions match_;
  AlignOptions align_;
  MatchCallback on_progress_;
  std::vector<Pose2> stops_ = drivers::OfficeTour();
  ScanMap map_;
  std::size_t next_ = 1;
  Pose3 last_pose_ = LaserAt(stops_[0]);
  Pose3 guess_;
  double error_of_guess_ = 0.0;
};

}  // namespace ariadne::slam
