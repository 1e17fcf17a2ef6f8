#pragma once

#include <gtest/gtest.h>

#include "planning/polygon/labelled_union.h"
#include "tests/planning/polygon/random_polygons.h"
#include "tests/planning/polygon/union_oracle.h"

namespace ariadne::planning {

constexpr LabelledUnionOptions kExact{0.0, 0.0};

inline std::vector<oracle::Piece> PiecesOf(const std::vector<LabelledPolygon>& polygons) {
  std::vector<oracle::Piece> pieces;
  const auto append = [&](const LabelledRing& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i)
      pieces.push_back({ring[i].p_map, ring[(i + 1) % ring.size()].p_map, ring[i].seen});
  };
  for (const LabelledPolygon& polygon : polygons) {
    append(polygon.outer);
    for (const LabelledRing& hole : polygon.holes) append(hole);
  }
  return pieces;
}

constexpr double kRoundingOfUnions =
    1.2e-5;  // a few steps of its grid where edges nearly lie on each other [m]

inline double DistanceTo(const oracle::Piece& piece, const Eigen::Vector2d& p) {
  const Eigen::Vector2d run = piece.to - piece.from;
  const double share = std::clamp((p - piece.from).dot(run) / run.squaredNorm(), 0.0, 1.0);
  return (p - piece.from - share * run).norm();
}

/// Places 0.25 mm apart near the ends of a piece, where labels may change, and sparser between.
inline std::vector<double> PlacesAlong(double length) {
  std::vector<double> places;
  const double fine = std::min(0.5 * length, 0.003);
  for (double x = 0.125e-3; x < fine; x += 0.25e-3) places.push_back(x);
  for (int i = 1; i < 8; ++i) places.push_back(i / 8.0 * length);
  for (double x = length - fine; x < length; x += 0.25e-3) places.push_back(x);
  std::ranges::sort(places);
  return places;
}

/// What is thinner than the rounding may vanish: a piece of the same boundary runs back beside the place.
inline bool InThinPart(const std::vector<oracle::Piece>& pieces, const oracle::Piece& piece,
                       const Eigen::Vector2d& p) {
  return std::ranges::any_of(pieces, [&](const oracle::Piece& other) {
    return (other.to - other.from).dot(piece.to - piece.from) < 0.0 &&
           DistanceTo(other, p) < kRoundingOfUnions;
  });
}

/// The longest stretch of a boundary that is not in the other with the same label [m].
inline double LongestWrong(const std::vector<oracle::Piece>& pieces,
                           const std::vector<oracle::Piece>& others) {
  double longest = 0.0;
  for (const oracle::Piece& piece : pieces) {
    const double length = piece.Length();
    if (length < 1e-3) continue;
    const Eigen::Vector2d along = (piece.to - piece.from) / length;
    double wrong = 0.0, last = 0.0;
    for (const double x : PlacesAlong(length)) {
      const Eigen::Vector2d p = piece.from + x * along;
      const bool found = std::ranges::any_of(others, [&](const oracle::Piece& other) {
        return other.seen == piece.seen && along.dot(other.to - other.from) > 0.0 &&
               DistanceTo(other, p) < kRoundingOfUnions;
      });
      wrong = found || InThinPart(pieces, piece, p) ? 0.0 : wrong + (x - last);
      last = x;
      longest = std::max(longest, wrong);
    }
  }
  return longest;
}

inline double LengthOf(const std::vector<oracle::Piece>& pieces, bool seen) {
  double length = 0.0;
  for (const oracle::Piece& piece : pieces) length += piece.seen == seen ? piece.Length() : 0.0;
  return length;
}

inline double Total(const std::vector<oracle::Piece>& pieces) {
  return LengthOf(pieces, true) + LengthOf(pieces, false);
}

/// Length of what may vanish, and of what is too short for a label of its own [m].
inline double Uncertain(const std::vector<oracle::Piece>& pieces) {
  double uncertain = 0.0;
  for (const oracle::Piece& piece : pieces) {
    uncertain += kRoundingOfUnions;  // both ends are rounded
    const double length = piece.Length();
    if (length < 1e-3) uncertain += length;
    if (length < 1e-3) continue;
    bool thin_before = false;
    for (int i = 0; i <= 64; ++i) {
      const bool thin = InThinPart(pieces, piece, piece.from + i / 64.0 * (piece.to - piece.from));
      if (thin != thin_before || thin) uncertain += length / 64.0;
      thin_before = thin;
    }
  }
  return uncertain;
}

/// Polygons against the exact boundary: every stretch of either beyond 1 mm is in the other, with its
/// label, and the lengths with either label are the same but for the rounding. Edges that touch to less
/// than the rounding, which no polygons on the axes' grid do, may also stay apart.
inline void CheckUnion(const std::vector<LabelledPolygon>& inputs,
                       const std::vector<LabelledPolygon>& united, bool turned) {
  const std::vector<oracle::Piece> expected = oracle::Boundary(inputs);
  const std::vector<oracle::Piece> pieces = PiecesOf(united);
  EXPECT_LE(LongestWrong(pieces, expected), 1e-3);
  EXPECT_LE(LongestWrong(expected, pieces), 1e-3);
  const double uncertain = Uncertain(expected) + (turned ? Uncertain(pieces) : 0.0);
  for (const bool seen : {false, true}) {
    EXPECT_NEAR(LengthOf(pieces, seen), LengthOf(expected, seen), uncertain) << seen;
  }
}

/// Unions of random polygons, and again of the result, whose holes and cut edges are then inputs, with more
/// polygons. Stops at the first that differs from the exact boundary.
inline void CheckRandomUnions(int rounds, std::uint64_t seed) {
  RandomStream stream = NamedStream(seed, "test/labelled_union");
  for (int round = 0; round < rounds && !testing::Test::HasFailure(); ++round) {
    SCOPED_TRACE(round);
    const slam::Pose2 T_map_grid = DrawTurn(stream, round);
    std::vector<LabelledPolygon> inputs = DrawPolygons(stream, round, T_map_grid);
    std::vector<LabelledPolygon> united = LabelledUnion(inputs, kExact);
    CheckUnion(inputs, united, round % 2 == 1);
    if (round % 8 > 1) continue;
    inputs = united;
    for (LabelledPolygon& polygon : inputs) RoundCorners(polygon);  // what the oracle can represent
    if (std::abs(Total(oracle::Boundary(inputs)) - Total(PiecesOf(inputs))) > 1e-9) continue;  // not simple
    inputs.push_back(Moved(T_map_grid, DrawStar(stream)));
    RoundCorners(inputs.back());
    CheckUnion(inputs, LabelledUnion(inputs, kExact), true);
  }
}

}  // namespace ariadne::planning
