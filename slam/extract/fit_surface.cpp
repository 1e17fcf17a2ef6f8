#include "slam/extract/fit_surface.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace ariadne::slam {
namespace {

using PointsInSpace = std::span<const Eigen::Vector3d>;

// The weights depend on the plane only through the angles at which the beams meet it: it settles at once.
constexpr int kPlaneReweightings = 2;
constexpr double kOnALine = 1e-12;  // share of the middle variance in the largest, below which is rounding

/// Weighted mean and scatter.
struct SpaceMoments {
  double weight = 0.0;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
};

SpaceMoments Gather(PointsInSpace points, const auto& weight_of) {
  SpaceMoments moments;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : points) {
    const double weight = weight_of(p);
    const Eigen::Vector3d local = p - points.front();  // keeps the digits
    moments.weight += weight;
    sum += weight * local;
    moments.scatter += weight * local * local.transpose();
  }
  const Eigen::Vector3d mean = sum / moments.weight;
  moments.scatter -= moments.weight * mean * mean.transpose();
  moments.mean = points.front() + mean;
  return moments;
}

/// Towards the scanner; nothing where two directions have no scatter.
std::optional<Eigen::Vector3d> NormalOf(const SpaceMoments& moments) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(moments.scatter);
  if (!(solver.eigenvalues()[1] > kOnALine * solver.eigenvalues()[2])) return std::nullopt;
  const Eigen::Vector3d normal = solver.eigenvectors().col(0);
  return normal.dot(moments.mean) > 0.0 ? Eigen::Vector3d(-normal) : normal;
}

/// Sums over the points in the frame of the plane. A turn about x lifts a point by its y, one about y
/// lowers it by its x, and the shift lifts it.
struct PlaneSums {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Vector3d alike = Eigen::Vector3d::Zero();   // all ranges too long by the same
  Eigen::Vector3d sloped = Eigen::Vector3d::Zero();  // the near ones by less than the far ones
  double weighted_squares = 0.0;
  double squares = 0.0;  // [m^2]
};

PlaneSums Sum(PointsInSpace points_laser, const Pose3& T_laser_plane, const SliceNoise& noise) {
  const Eigen::Vector3d normal = T_laser_plane.rotation * Eigen::Vector3d::UnitZ();
  const Eigen::Matrix3d to_plane = T_laser_plane.RotationMatrix().transpose();
  const double middle = T_laser_plane.translation.norm();
  PlaneSums sums;
  for (const Eigen::Vector3d& p : points_laser) {
    const Eigen::Vector3d q = to_plane * (p - T_laser_plane.translation);
    const double weight = std::pow(SigmaAcross(normal, p, noise), -2);
    const Eigen::Vector3d lift(q.y(), -q.x(), 1.0);
    const double range = p.norm();
    const double ahead = range > 0.0 ? normal.dot(p) / range : 0.0;
    sums.information += weight * lift * lift.transpose();
    sums.alike += weight * ahead * lift;
    sums.sloped +=
        weight * ahead * std::clamp((range - middle) / noise.systematic_length, -1.0, 1.0) * lift;
    sums.weighted_squares += weight * q.z() * q.z();
    sums.squares += q.z() * q.z();
  }
  return sums;
}

Eigen::Matrix3d CovarianceOf(const PlaneSums& sums, double count, const SliceNoise& noise) {
  const Eigen::Matrix3d inverse = sums.information.ldlt().solve(Eigen::Matrix3d::Identity());
  const double trust = noise.prior_points + count - 3.0;
  const double scale = trust > 0.0 ? (noise.prior_points + sums.weighted_squares) / trust : 1.0;
  const Eigen::Vector3d alike = inverse * sums.alike, sloped = inverse * sums.sloped;
  const double shared = noise.systematic_sigma * noise.systematic_sigma;
  return scale * inverse + shared * (alike * alike.transpose() + sloped * sloped.transpose());
}

}  // namespace

double SigmaAcross(const Eigen::Vector3d& normal, const Eigen::Vector3d& p, const SliceNoise& noise) {
  const double range = p.norm();
  if (range == 0.0) return noise.range_sigma;  // from no direction
  const double ahead = normal.dot(p) / range;
  const double aside = range * std::sqrt(std::max(0.0, 1.0 - ahead * ahead));
  return std::hypot(noise.range_sigma * ahead, noise.bearing_sigma * aside) +
         kLeastSigma * noise.range_sigma;
}

double SystematicAcross(const Eigen::Vector3d& normal, const Eigen::Vector3d& p, double difference,
                        const SliceNoise& noise) {
  const double range = p.norm();
  if (range == 0.0) return 0.0;
  const double ahead = std::abs(normal.dot(p)) / range;
  return noise.systematic_sigma * ahead * std::min(1.0, std::abs(difference) / noise.systematic_length);
}

std::optional<PlanarSurface> FitSurface(PointsInSpace points_laser, const SliceNoise& noise) {
  if (points_laser.size() < 3) return std::nullopt;
  SpaceMoments moments = Gather(points_laser, [](const Eigen::Vector3d&) { return 1.0; });
  std::optional<Eigen::Vector3d> normal = NormalOf(moments);
  for (int pass = 0; pass < kPlaneReweightings && normal; ++pass) {
    moments = Gather(points_laser, [&](const Eigen::Vector3d& p) {
      return std::pow(SigmaAcross(*normal, p, noise), -2);
    });
    normal = NormalOf(moments);
  }
  if (!normal) return std::nullopt;
  PlanarSurface surface;
  surface.T_frame_plane = PlaneFrame(moments.mean, *normal);
  const PlaneSums sums = Sum(points_laser, surface.T_frame_plane, noise);
  surface.points = points_laser.size();
  surface.rms = std::sqrt(sums.squares / static_cast<double>(surface.points));
  surface.covariance = CovarianceOf(sums, static_cast<double>(surface.points), noise);
  return surface;
}

}  // namespace ariadne::slam
