#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

/// What an occupancy grid remembers of its cells while scans are added, by their indices.
namespace ariadne::slam {

/// Between which heights the points of each cell are [m].
class SeenHeights {
 public:
  /// `tolerance` [m] is added above and below.
  SeenHeights(std::size_t cells, double tolerance) : ranges_(cells), tolerance_(tolerance) {}

  void Add(std::size_t cell, double z) {
    ranges_[cell].low = std::min(ranges_[cell].low, static_cast<float>(z - tolerance_));
    ranges_[cell].high = std::max(ranges_[cell].high, static_cast<float>(z + tolerance_));
  }
  /// Whether a beam that goes through the cell between these heights would have met what is there.
  bool WouldMeet(std::size_t cell, double z1, double z2) const {
    const Range& range = ranges_[cell];
    return range.low > range.high || (std::max(z1, z2) >= range.low && std::min(z1, z2) <= range.high);
  }

 private:
  struct Range {
    float low = std::numeric_limits<float>::max();
    float high = std::numeric_limits<float>::lowest();
  };
  std::vector<Range> ranges_;
  double tolerance_;
};

enum class Vote : char { kNone, kFor, kAgainst };

/// What a vote counts, in log odds.
struct VoteOdds {
  double hit;
  double miss;
  double most;  // the bound of their sum, for or against
};

/// The votes of one scan: the first for a cell counts.
class Ballot {
 public:
  explicit Ballot(std::size_t cells) : votes_(cells, Vote::kNone) {}

  bool HasVoted(std::size_t cell) const { return votes_[cell] != Vote::kNone; }

  void Cast(std::size_t cell, Vote vote) {
    if (HasVoted(cell)) return;
    votes_[cell] = vote;
    voted_.push_back(cell);
  }

  /// Adds the votes to the log odds of the cells, and begins anew.
  void CountInto(std::vector<float>& log_odds, const VoteOdds& odds) {
    for (const std::size_t cell : voted_) {
      const double sum = log_odds[cell] + (votes_[cell] == Vote::kFor ? odds.hit : -odds.miss);
      log_odds[cell] = static_cast<float>(std::clamp(sum, -odds.most, odds.most));
      votes_[cell] = Vote::kNone;
    }
    voted_.clear();
  }

 private:
  std::vector<Vote> votes_;
  std::vector<std::size_t> voted_;
};

}  // namespace ariadne::slam
