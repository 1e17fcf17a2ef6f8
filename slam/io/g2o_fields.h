#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "slam/geometry/pose2.h"
#include "slam/geometry/pose3.h"
#include "slam/io/row_parser.h"
#include "slam/io/stream_reader.h"

namespace ariadne::slam {

/// Cuts one record of a g2o file into its fields. Error with file and line where they are not what they
/// should be.
class G2oFields {
 public:
  G2oFields(const StreamReader& reader, RowParser& parser, std::string_view line);

  /// The first word: "EDGE_SE2".
  std::string_view tag() const { return tag_; }

  /// The next number of a vertex or parameter.
  std::int64_t NextId();
  bool AtEnd() const { return IsBlankLine(rest_); }

  /// All that is left: exactly `count` finite numbers.
  std::span<const double> Numbers(std::size_t count);

 private:
  std::string_view NextWord();

  const StreamReader& reader_;
  RowParser& parser_;
  std::string_view rest_;
  std::string_view tag_;
};

/// x y theta.
Pose2 G2oPose2(std::span<const double> n);
/// x y z qx qy qz qw; the quaternion is of length 1 within 1e-2, and made so.
Pose3 G2oPose3(const StreamReader& reader, std::span<const double> n);
/// x y z roll pitch yaw, the way of TORO.
Pose3 ToroPose3(std::span<const double> n);

/// The six entries of a symmetric matrix: rows of the upper triangle; and in the order of TORO,
/// xx xy yy tt xt yt.
Pose2::Square G2oInformation2(const StreamReader& reader, std::span<const double> n);
Pose2::Square ToroInformation2(const StreamReader& reader, std::span<const double> n);
/// The upper triangle on (translation, vec(q)), as information on (translation, angle); and that of TORO,
/// which is on the angle already.
Pose3::Square G2oInformation3(const StreamReader& reader, std::span<const double> n);
Pose3::Square ToroInformation3(const StreamReader& reader, std::span<const double> n);

}  // namespace ariadne::slam
