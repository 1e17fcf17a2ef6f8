#include "slam/io/g2o_fields.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

#include "slam/geometry/angles.h"
#include "slam/geometry/so3.h"

namespace ariadne::slam {
namespace {

/// A symmetric matrix from the rows of its upper triangle.
template <int kSize>
Eigen::Matrix<double, kSize, kSize> FromUpperTriangle(std::span<const double> n) {
  Eigen::Matrix<double, kSize, kSize> matrix;
  std::size_t next = 0;
  for (int row = 0; row < kSize; ++row) {
    for (int column = row; column < kSize; ++column) {
      matrix(row, column) = matrix(column, row) = n[next++];
    }
  }
  return matrix;
}

/// A matrix without a positive eigenvalue holds nothing, or pushes apart.
template <typename Square>
const Square& RequireSomeInformation(const StreamReader& reader, const Square& information) {
  if ((information.diagonal().array() > 0.0).any()) return information;
  // Scaled, for the squares of large numbers have no room in a double.
  const double largest = information.cwiseAbs().maxCoeff();
  if (largest > 0.0) {
    const Eigen::SelfAdjointEigenSolver<Square> solver(information / largest, Eigen::EigenvaluesOnly);
    if (solver.eigenvalues().maxCoeff() > 1e-12) return information;
  }
  reader.FailAtLine("the information matrix has no positive eigenvalue, so that the edge means nothing; {}",
                    "correct or remove it");
}

}  // namespace

G2oFields::G2oFields(const StreamReader& reader, RowParser& parser, std::string_view line)
    : reader_(reader), parser_(parser), rest_(line) {
  tag_ = NextWord();
}

std::string_view G2oFields::NextWord() {
  rest_.remove_prefix(std::min(rest_.find_first_not_of(kBlanks), rest_.size()));
  const std::string_view word = rest_.substr(0, rest_.find_first_of(kBlanks));
  rest_.remove_prefix(word.size());
  return word;
}

std::int64_t G2oFields::NextId() {
  const std::string_view word = NextWord();
  if (word.empty())
    reader_.FailAtLine("the number of a vertex is missing after {}; complete the line", tag_);
  std::int64_t id = 0;
  const auto [after, error] = std::from_chars(word.data(), word.data() + word.size(), id);
  if (error != std::errc() || after != word.data() + word.size()) {
    reader_.FailAtLine("{} is not the number of a vertex; expected a whole number", Quoted(word));
  }
  return id;
}

std::span<const double> G2oFields::Numbers(std::size_t count) {
  const std::span<const double> numbers = parser_.Parse(rest_);
  if (numbers.size() != count) {
    reader_.FailAtLine("found {} numbers after the numbers of the vertices, {} has {}", numbers.size(),
                       tag_, count);
  }
  for (const double number : numbers) {
    if (!std::isfinite(number)) reader_.FailAtLine("a number of the {} is NaN or infinite", tag_);
  }
  return numbers;
}

Pose2 G2oPose2(std::span<const double> n) { return {WrapAngle(n[2]), {n[0], n[1]}}; }

Pose3 G2oPose3(const StreamReader& reader, std::span<const double> n) {
  constexpr double kUnitTolerance = 1e-2;
  const Eigen::Quaterniond q(n[6], n[3], n[4], n[5]);
  const double norm = q.norm();
  if (!(std::abs(norm - 1.0) <= kUnitTolerance)) {
    reader.FailAtLine("the quaternion has length {:.6g} instead of 1; order it qx qy qz qw", norm);
  }
  // One that is unit to the last digits stays as it is, so that what was written is read again.
  const bool unit = std::abs(norm - 1.0) < 4.0 * std::numeric_limits<double>::epsilon();
  return {unit ? q : q.normalized(), {n[0], n[1], n[2]}};
}

Pose3 ToroPose3(std::span<const double> n) {
  const Eigen::Quaterniond rotation =
      ExpSo3({0.0, 0.0, n[5]}) * ExpSo3({0.0, n[4], 0.0}) * ExpSo3({n[3], 0.0, 0.0});
  return {rotation.normalized(), {n[0], n[1], n[2]}};
}

Pose2::Square G2oInformation2(const StreamReader& reader, std::span<const double> n) {
  return RequireSomeInformation(reader, FromUpperTriangle<3>(n));
}

Pose2::Square ToroInformation2(const StreamReader& reader, std::span<const double> n) {
  const std::array<double, 6> upper{n[0], n[1], n[4], n[2], n[5], n[3]};
  return G2oInformation2(reader, upper);
}

Pose3::Square G2oInformation3(const StreamReader& reader, std::span<const double> n) {
  Pose3::Square information = FromUpperTriangle<6>(n);
  information.bottomRows<3>() *= 0.5;
  information.rightCols<3>() *= 0.5;
  return RequireSomeInformation(reader, information);
}

Pose3::Square ToroInformation3(const StreamReader& reader, std::span<const double> n) {
  return RequireSomeInformation(reader, FromUpperTriangle<6>(n));
}

}  // namespace ariadne::slam
