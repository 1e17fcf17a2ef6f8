#include "slam/map/octree_leaf.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace ariadne::slam {
namespace {

/// A direction as a point of the octahedron |x| + |y| + |z| = 1, unfolded into a square of 256 x 256.
std::uint32_t DirectionCode(const Eigen::Vector3d& direction) {
  const double size = direction.lpNorm<1>();
  if (!(size > 0.0)) return 0;
  double u = direction.x() / size;
  double v = direction.y() / size;
  if (direction.z() < 0.0) {
    const double folded_u = std::copysign(1.0 - std::abs(v), u);
    v = std::copysign(1.0 - std::abs(u), v);
    u = folded_u;
  }
  // Up by the half of a step first: lround would cost as much as all the rest.
  const auto code = [](double w) { return static_cast<std::uint32_t>(127.5 + 127.0 * w); };
  return code(u) << 8 | code(v);
}

/// The upper half of a view's code: exponent and 8 bits of the squared distance.
std::uint32_t DistanceCode(const Eigen::Vector3d& viewpoint_from_p) {
  return std::bit_cast<std::uint32_t>(static_cast<float>(viewpoint_from_p.squaredNorm())) >> 15;
}

Eigen::Vector3d DirectionOf(std::uint32_t code) {
  const auto coordinate = [](std::uint32_t byte) { return static_cast<double>(byte) / 127.0 - 1.0; };
  double u = coordinate(code >> 8 & 0xFF);
  double v = coordinate(code & 0xFF);
  const double z = 1.0 - std::abs(u) - std::abs(v);
  if (z < 0.0) {
    const double unfolded_u = std::copysign(1.0 - std::abs(v), u);
    v = std::copysign(1.0 - std::abs(u), v);
    u = unfolded_u;
  }
  return Eigen::Vector3d(u, v, z).normalized();
}

}  // namespace

Eigen::Matrix3d CellMoments::Scatter() const {
  const auto& s = scatter;
  return Eigen::Matrix3d{{s[0], s[1], s[2]}, {s[1], s[3], s[4]}, {s[2], s[4], s[5]}};
}

CellMoments Merged(const CellMoments& a, const CellMoments& b) {
  CellMoments both;
  both.count = a.count + b.count;
  const double share = static_cast<double>(b.count) / static_cast<double>(both.count);
  const double weight = static_cast<double>(a.count) * share;
  const Eigen::Vector3d d = b.mean - a.mean;
  both.mean = a.mean + share * d;
  const std::array<double, 6> squares{d.x() * d.x(), d.x() * d.y(), d.x() * d.z(),
                                      d.y() * d.y(), d.y() * d.z(), d.z() * d.z()};
  for (std::size_t i = 0; i < 6; ++i) both.scatter[i] = a.scatter[i] + b.scatter[i] + weight * squares[i];
  both.reflectance = a.reflectance + share * (b.reflectance - a.reflectance);
  both.view = std::min(a.view, b.view);
  return both;
}

std::uint32_t ViewCode(const Eigen::Vector3d& viewpoint_from_p) {
  return DistanceCode(viewpoint_from_p) << 16 | DirectionCode(viewpoint_from_p);
}

Eigen::Vector3d ViewDirection(std::uint32_t view) { return DirectionOf(view & 0xFFFF); }

Eigen::Vector3d NormalOf(const CellMoments& moments) {
  constexpr double kLine = 1e-6;  // of the longest axis' variance: thinner than this is a line
  if (moments.count < 3) return Eigen::Vector3d::Zero();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes;
  axes.computeDirect(moments.Scatter());
  const Eigen::Vector3d& variances = axes.eigenvalues();
  if (!(variances[1] > kLine * variances[2])) return Eigen::Vector3d::Zero();
  const Eigen::Vector3d normal = axes.eigenvectors().col(0);
  return normal.dot(ViewDirection(moments.view)) < 0.0 ? Eigen::Vector3d(-normal) : normal;
}

void OctreeLeaf::Add(const CellMoments& more_center, const Eigen::Vector3d& viewpoint_from_center) {
  const std::uint32_t view = view_;
  Store(count_ == 0 ? more_center : Merged(Moments(), more_center));
  const bool nearer =
      DistanceCode(viewpoint_from_center) <= view >> 16;  // else its direction does not count
  view_ = nearer ? std::min(view, ViewCode(viewpoint_from_center)) : view;
}

void OctreeLeaf::Store(const CellMoments& moments_center) {
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint32_t>::max();
  for (int i = 0; i < 3; ++i) mean_[i] = static_cast<float>(moments_center.mean[i]);
  for (std::size_t i = 0; i < 6; ++i) scatter_[i] = static_cast<float>(moments_center.scatter[i]);
  reflectance_ = static_cast<float>(moments_center.reflectance);
  count_ = static_cast<std::uint32_t>(std::min(moments_center.count, kMost));
}

CellMoments OctreeLeaf::Moments() const {
  CellMoments moments;
  moments.count = count_;
  moments.mean = {mean_[0], mean_[1], mean_[2]};
  for (std::size_t i = 0; i < 6; ++i) moments.scatter[i] = scatter_[i];
  moments.reflectance = reflectance_;
  moments.view = view_;
  return moments;
}

}  // namespace ariadne::slam
