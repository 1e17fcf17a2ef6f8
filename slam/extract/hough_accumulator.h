#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

namespace ariadne::slam {

/// Votes of points for the lines x cos(theta) + y sin(theta) = rho through them: R x R cells over theta in
/// [-pi/2, pi/2) and rho in [-L, L], L the diagonal of the box around the points, relative to the corner of
/// that box.
class HoughAccumulator {
 public:
  static constexpr std::size_t kMaxPoints = 16000;  // cells are 16 bits, half of them for those closed

  /// All points vote. `cells_per_meter` is R / L.
  HoughAccumulator(std::span<const Eigen::Vector2d> points, double cells_per_meter);

  struct Peak {
    int votes = 0;
    std::size_t theta_cell = 0;
    std::size_t rho_cell = 0;
    double theta = 0.0;   // of the normal [rad]
    double offset = 0.0;  // of the line from the origin of the points: x cos + y sin = offset [m]
  };

  /// The cell with most votes; of several, the one with the lowest theta, then rho.
  Peak Highest();

  /// Takes the votes of points back.
  void Withdraw(std::span<const Eigen::Vector2d> points);

  /// A cell that is not to be found again.
  void Close(const Peak& peak);

 private:
  void AddVotes(std::span<const Eigen::Vector2d> points, std::int16_t votes);
  /// Of a point relative to the corner; the same for its vote as for taking it back.
  std::int32_t RhoCell(std::size_t theta_cell, float x, float y) const;
  std::span<std::int16_t> Row(std::size_t theta_cell);
  std::size_t HighestRow();
  std::int16_t MaximumOf(std::size_t theta_cell);

  Eigen::Vector2d corner_ = Eigen::Vector2d::Zero();
  double max_rho_ = 0.0;
  std::size_t cells_ = 1;           // R
  std::vector<float> cells_per_x_;  // of each theta [1/m]
  std::vector<float> cells_per_y_;
  std::vector<std::int16_t> votes_;       // row by row, a row is one theta
  std::vector<std::int16_t> row_bounds_;  // no cell of the row has more: votes are only taken back
};

}  // namespace ariadne::slam
