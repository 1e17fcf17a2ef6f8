#include "drivers/calibration/calibrate_scanner.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <string_view>
#include <vector>

#include "slam/base/error.h"

namespace ariadne::drivers {
namespace {

constexpr int kOwn = ScannerMounting::kSize;
constexpr int kWallSize = 2;              // bearing and offset; a ceiling has its height alone
constexpr double kTukey = 4.685;          // in sigmas: 95 % efficient where errors are Gaussian
constexpr std::size_t kFewestBeams = 20;  // of a plane
constexpr double kConverged = 1e-7;       // [m, rad]
constexpr std::array<std::string_view, kOwn> kNames{"roll",           "pitch",     "height",
                                                    "mirror_forward", "mirror_up", "range_offset"};
constexpr std::array<bool, kOwn> kIsAngle{true, true, false, false, false, false};

/// The distance of a beam's end from its plane, and what it depends on: the mounting, and at most two
/// numbers of the plane itself from column `first` on.
struct PlaneResidual {
  double distance = 0.0;
  Eigen::Matrix<double, 1, kOwn> of_mounting;
  Eigen::RowVector2d of_plane = Eigen::RowVector2d::Zero();
};

/// Gauss-Newton on all unknowns: those of the mounting, then those of the planes.
class MountingSolver {
 public:
  MountingSolver(std::span<const CalibrationPlane> planes, const ScannerMounting& guess,
                 const CalibrateScannerOptions& options);
  ScannerCalibration Solve();

 private:
  PlaneResidual ResidualOf(const CalibrationPlane& plane, Eigen::Index first,
                           const MeasuredBeam& beam) const;
  template <typename Visit>
  void ForEach(const Visit& visit) const;
  double RobustSigma() const;
  double Step();
  Eigen::MatrixXd Covariance() const;

  std::span<const CalibrationPlane> planes_;
  const CalibrateScannerOptions& options_;
  std::vector<Eigen::Index> first_;  // unknown of each plane
  Eigen::VectorXd x_;
  double sigma_ = 0.0;   // [m]
  double widest_ = 1.0;  // that sigma is at least [m]
};

Eigen::Index UnknownsOf(const CalibrationPlane& plane) {
  if (plane.kind == PlaneKind::kFloor) return 0;
  return plane.kind == PlaneKind::kWall ? kWallSize : 1;
}

MountingSolver::MountingSolver(std::span<const CalibrationPlane> planes, const ScannerMounting& guess,
                               const CalibrateScannerOptions& options)
    : planes_(planes), options_(options) {
  Eigen::Index size = kOwn;
  for (const CalibrationPlane& plane : planes) {
    first_.push_back(size);
    size += UnknownsOf(plane);
  }
  x_.setZero(size);
  x_.head<kOwn>() = guess.ToVector();
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (planes[i].kind == PlaneKind::kCeiling) x_[first_[i]] = planes[i].offset;
    if (planes[i].kind == PlaneKind::kWall)
      x_.segment<2>(first_[i]) = Eigen::Vector2d(planes[i].bearing, planes[i].offset);
  }
}

PlaneResidual MountingSolver::ResidualOf(const CalibrationPlane& plane, Eigen::Index first,
                                         const MeasuredBeam& beam) const {
  const BeamEnd end = EndOf(beam, ScannerMounting::Of(x_.head<kOwn>()));
  PlaneResidual residual;
  if (plane.kind != PlaneKind::kWall) {
    residual.distance = end.p_base.z() - (plane.kind == PlaneKind::kCeiling ? x_[first] : 0.0);
    residual.of_mounting = end.derivative.row(2);
    residual.of_plane[0] = -1.0;
    return residual;
  }
  const Eigen::Vector3d normal(std::cos(x_[first]), std::sin(x_[first]), 0.0);
  residual.distance = normal.dot(end.p_base) - x_[first + 1];
  residual.of_mounting = normal.transpose() * end.derivative;
  residual.of_plane << -normal.y() * end.p_base.x() + normal.x() * end.p_base.y(), -1.0;
  return residual;
}

template <typename Visit>
void MountingSolver::ForEach(const Visit& visit) const {
  for (std::size_t i = 0; i < planes_.size(); ++i) {
    for (std::size_t k = 0; k < planes_[i].beams.size(); ++k)
      visit(ResidualOf(planes_[i], first_[i], planes_[i].beams[k]), first_[i], UnknownsOf(planes_[i]),
            planes_[i].slices[k]);
  }
}

double MountingSolver::RobustSigma() const {
  std::vector<double> distances;
  ForEach([&](const PlaneResidual& residual, Eigen::Index, Eigen::Index, std::size_t) {
    distances.push_back(std::abs(residual.distance));
  });
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return std::max(1e-6, 1.4826 * *middle);
}

/// The largest change of an unknown of the mounting.
double MountingSolver::Step() {
  // At first all points count: a mount that is far off leaves whole surfaces for outliers.
  widest_ *= 0.5;
  sigma_ = std::max(widest_, RobustSigma());
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(x_.size(), x_.size());
  Eigen::VectorXd g = Eigen::VectorXd::Zero(x_.size());
  ForEach([&](const PlaneResidual& residual, Eigen::Index first, Eigen::Index size, std::size_t) {
    const double u = residual.distance / (kTukey * sigma_);
    if (std::abs(u) >= 1.0) return;
    const double weight = (1.0 - u * u) * (1.0 - u * u);
    const auto of_plane = residual.of_plane.head(size);
    A.topLeftCorner<kOwn, kOwn>() += weight * residual.of_mounting.transpose() * residual.of_mounting;
    A.block(first, 0, size, kOwn) += weight * of_plane.transpose() * residual.of_mounting;
    A.block(first, first, size, size) += weight * of_plane.transpose() * of_plane;
    g.head<kOwn>() += weight * residual.distance * residual.of_mounting.transpose();
    g.segment(first, size) += weight * residual.distance * of_plane.transpose();
  });
  const double prior = std::pow(sigma_ / options_.range_offset_sigma, 2);
  A(kOwn - 1, kOwn - 1) += prior;
  g[kOwn - 1] += prior * x_[kOwn - 1];
  // A little damping, so that what cannot be told stays where it was guessed instead of anywhere.
  A.diagonal() += 1e-9 * A.diagonal() + Eigen::VectorXd::Constant(x_.size(), 1e-9);
  const Eigen::VectorXd step = A.selfadjointView<Eigen::Lower>().ldlt().solve(-g);
  x_ += step;
  return step.head<kOwn>().cwiseAbs().maxCoeff();
}

/// The sandwich: (sum of psi')^-1 (sum over slices of their sums, squared) (sum of psi')^-1.
Eigen::MatrixXd MountingSolver::Covariance() const {
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(x_.size(), x_.size());
  std::map<std::size_t, Eigen::VectorXd> of_slices;
  ForEach([&](const PlaneResidual& residual, Eigen::Index first, Eigen::Index size, std::size_t slice) {
    const double u = residual.distance / (kTukey * sigma_);
    if (std::abs(u) >= 1.0) return;
    const double psi = residual.distance * (1.0 - u * u) * (1.0 - u * u);
    const double slope = (1.0 - u * u) * (1.0 - 5.0 * u * u);
    const auto of_plane = residual.of_plane.head(size);
    A.topLeftCorner<kOwn, kOwn>() += slope * residual.of_mounting.transpose() * residual.of_mounting;
    A.block(first, 0, size, kOwn) += slope * of_plane.transpose() * residual.of_mounting;
    A.block(first, first, size, size) += slope * of_plane.transpose() * of_plane;
    Eigen::VectorXd& sum = of_slices.try_emplace(slice, Eigen::VectorXd::Zero(x_.size())).first->second;
    sum.head<kOwn>() += psi * residual.of_mounting.transpose();
    sum.segment(first, size) += psi * of_plane.transpose();
  });
  Eigen::MatrixXd B = Eigen::MatrixXd::Zero(x_.size(), x_.size());
  for (const auto& [slice, sum] : of_slices) B += sum * sum.transpose();
  const auto slices = static_cast<double>(of_slices.size());
  const auto unknowns = static_cast<double>(x_.size());
  if (slices <= unknowns + 1.0)
    Fail("the scans have {} slices on surfaces, too few to calibrate by; take whole scans", slices);
  B *= slices / (slices - unknowns);
  const double prior = std::pow(sigma_ / options_.range_offset_sigma, 2);
  A(kOwn - 1, kOwn - 1) += prior;
  B(kOwn - 1, kOwn - 1) += prior * sigma_ * sigma_;
  const Eigen::MatrixXd whole = A.selfadjointView<Eigen::Lower>();
  const Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver(whole);
  if (solver.rank() < x_.size()) return Eigen::MatrixXd::Constant(kOwn, kOwn, 1e6);
  const Eigen::MatrixXd half = solver.solve(B);
  return solver.solve(half.transpose()).topLeftCorner<kOwn, kOwn>();
}

ScannerCalibration MountingSolver::Solve() {
  ScannerCalibration result;
  double change = 1.0;
  for (; (change > kConverged || sigma_ <= widest_) && result.iterations < options_.max_iterations;
       ++result.iterations)
    change = Step();
  result.settled = change <= kConverged;
  result.mounting = ScannerMounting::Of(x_.head<kOwn>());
  result.covariance = Covariance();
  result.rms = sigma_;
  for (const CalibrationPlane& plane : planes_) {
    result.points += plane.beams.size();
    ++(plane.kind == PlaneKind::kFloor  ? result.floors
       : plane.kind == PlaneKind::kWall ? result.walls
                                        : result.ceilings);
  }
  return result;
}

/// A sentence for the first number that the scans do not tell.
void CheckCertainty(const ScannerCalibration& result, const CalibrateScannerOptions& options) {
  for (int i = 0; i < kOwn - 1; ++i) {  // the range offset has its data sheet
    const auto at = static_cast<std::size_t>(i);
    const double sigma = std::sqrt(std::max(0.0, result.covariance(i, i)));
    const double limit = kIsAngle[at] ? options.max_sigma_angle : options.max_sigma_length;
    if (sigma <= limit) continue;
    Fail(
        "the scans do not tell {}: it remains uncertain by {:.2g} {}, more than {}; scan where the floor, "
        "a wall ahead and walls beside are seen from low to high",
        kNames[at], std::min(sigma, 1e3), kIsAngle[at] ? "rad" : "m", limit);
  }
}

void CheckPlausible(const ScannerCalibration& result, const ScannerMounting& guess,
                    const CalibrateScannerOptions& options) {
  const ScannerMounting::Vector change = result.mounting.ToVector() - guess.ToVector();
  const std::array<double, kOwn> limits{options.max_angle,         options.max_angle,
                                        options.max_height_error,  options.max_mirror_offset,
                                        options.max_mirror_offset, 4.0 * options.range_offset_sigma};
  for (int i = 0; i < kOwn; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double by = i < 3 ? change[i] : result.mounting.ToVector()[i];
    if (std::abs(by) <= limits[at]) continue;
    Fail(
        "a {} of {:.3f} {} is {:.3f} beyond what was expected, more than {}; see the mount, or give a "
        "better first guess",
        kNames[at], result.mounting.ToVector()[i], kIsAngle[at] ? "rad" : "m", std::abs(by), limits[at]);
  }
  if (result.rms > options.max_rms) {
    Fail(
        "points lie {:.3f} m from their surfaces, more than {}; did something move, or does the servo "
        "skip?",
        result.rms, options.max_rms);
  }
}

}  // namespace

ScannerCalibration CalibrateOnPlanes(std::span<const CalibrationPlane> planes, const ScannerMounting& guess,
                                     const CalibrateScannerOptions& options) {
  CheckOptions(options, "scanner.");
  const bool floor = std::ranges::any_of(
      planes, [](const CalibrationPlane& plane) { return plane.kind == PlaneKind::kFloor; });
  if (!floor)
    Fail("no floor is seen in the scans; tilt the scanner down far enough, and scan a free floor");
  std::vector<CalibrationPlane> told;
  std::ranges::copy_if(planes, std::back_inserter(told),
                       [](const CalibrationPlane& plane) { return plane.beams.size() >= kFewestBeams; });
  ScannerCalibration result = MountingSolver(told, guess, options).Solve();
  CheckCertainty(result, options);
  if (!result.settled) {
    Fail(
        "the calibration of the scanner does not settle after {} iterations; scan where floor, walls and "
        "nothing that moves can be seen",
        result.iterations);
  }
  CheckPlausible(result, guess, options);
  return result;
}

ScannerCalibration CalibrateScanner(std::span<const slam::Scan> scans, const ScannerMounting& guess,
                                    const CalibrateScannerOptions& options) {
  if (scans.empty()) Fail("there are no scans to calibrate by");
  return CalibrateOnPlanes(FindCalibrationPlanes(scans, guess, options.planes), guess, options);
}

}  // namespace ariadne::drivers
