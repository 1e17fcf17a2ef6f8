#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/random_geometry.h"

/// Clouds on which a nearest-neighbour search can go wrong.
namespace ariadne::slam {

/// A cubic lattice of n^3 points in random order. Distances to and between its nodes tie.
inline std::vector<Eigen::Vector3d> ShuffledLattice(int n, double spacing, const Eigen::Vector3d& corner,
                                                    int copies = 1) {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < copies * n * n * n; ++i) {
    points.emplace_back(corner + spacing * Eigen::Vector3d(i % n, i / n % n, i / (n * n) % n));
  }
  RandomStream stream = NamedStream(1, "difficult_clouds/shuffle");
  for (std::size_t i = points.size() - 1; i > 0; --i) std::swap(points[i], points[stream() % (i + 1)]);
  return points;
}

struct NamedCloud {
  std::string name;
  std::vector<Eigen::Vector3d> points;
};

inline std::vector<NamedCloud> DifficultClouds() {
  RandomStream stream = NamedStream(1, "difficult_clouds");
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  const Eigen::Vector3d far = Eigen::Vector3d(1e6, -1e6, 1e6);
  std::vector<NamedCloud> clouds = {
      {"empty", {}},
      {"one point", {{1.0, 2.0, 3.0}}},
      {"the same point 100 times", {100, {1.0, 2.0, 3.0}}},
      {"random", DrawCloud(stream, 500, 2.0)},
      {"lattice", ShuffledLattice(7, 0.25, zero)},
      {"lattice with every node three times", ShuffledLattice(5, 0.25, zero, 3)},
      {"lattice far away", ShuffledLattice(6, 0.25, far)},
      {"random far away", DrawCloud(stream, 300, 1.0)},
      {"random on a line", DrawCloud(stream, 200, 3.0)}};
  for (Eigen::Vector3d& p : clouds[7].points) p += far;
  for (Eigen::Vector3d& p : clouds[8].points) p.y() = p.z() = 0.5;
  return clouds;
}

/// For INSTANTIATE_TEST_SUITE_P.
inline std::string NameForTest(const testing::TestParamInfo<NamedCloud>& cloud) {
  std::string name = cloud.param.name;
  std::ranges::replace(name, ' ', '_');
  return name;
}

/// Places in and around a cloud: at its points, half way between two, near one, and far outside.
inline std::vector<Eigen::Vector3d> QueriesFor(const std::vector<Eigen::Vector3d>& points) {
  RandomStream stream = NamedStream(1, "difficult_clouds/queries");
  std::vector<Eigen::Vector3d> queries = {Eigen::Vector3d::Zero(), {100.0, -50.0, 1.0}};
  for (int i = 0; i < 60 && !points.empty(); ++i) {
    const Eigen::Vector3d& a = points[stream() % points.size()];
    const Eigen::Vector3d& b = points[stream() % points.size()];
    queries.insert(queries.end(), {a, 0.5 * (a + b), a + DrawInCube(stream, 0.3)});
  }
  return queries;
}

}  // namespace ariadne::slam
