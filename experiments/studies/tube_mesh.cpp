#include "experiments/studies/tube_mesh.h"

#include "drivers/simulated/solids.h"

namespace ariadne::experiments {
namespace {

using Eigen::Vector3d;

constexpr int kBarSides = 40;
constexpr int kTubeSides = 8;

void AppendJoint(slam::TriangleMesh& mesh, const Vector3d& center, double radius, slam::Rgb color) {
  AppendPainted(mesh, drivers::MakeEllipsoid(center, Vector3d::Constant(radius), kTubeSides), color);
}

}  // namespace

void AppendPainted(slam::TriangleMesh& mesh, slam::TriangleMesh part, slam::Rgb color) {
  part.colors.assign(part.vertices.size(), color);
  slam::Append(mesh, part);
}

void AppendBar(slam::TriangleMesh& mesh, const Vector3d& from, const Vector3d& to, double radius,
               slam::Rgb color) {
  AppendPainted(mesh, drivers::MakeRod(from, to, radius, radius, kBarSides), color);
}

void AppendTube(slam::TriangleMesh& mesh, std::span<const Vector3d> line, double radius, slam::Rgb color) {
  if (line.empty()) return;
  AppendJoint(mesh, line.front(), radius, color);
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (line[i] == line[i - 1]) continue;
    AppendPainted(mesh, drivers::MakeRod(line[i - 1], line[i], radius, radius, kTubeSides), color);
    AppendJoint(mesh, line[i], radius, color);
  }
}

void AppendBoxEdges(slam::TriangleMesh& mesh, const slam::Box3& box, double radius, slam::Rgb color) {
  for (int bits = 0; bits < 8; ++bits) {
    for (const int axis : {1, 2, 4}) {
      if ((bits & axis) != 0) continue;
      const auto corner = [&box](int which) -> Vector3d {
        return box.corner(static_cast<slam::Box3::CornerType>(which));
      };
      const Vector3d edge[] = {corner(bits), corner(bits | axis)};
      AppendTube(mesh, edge, radius, color);
    }
  }
}

}  // namespace ariadne::experiments
