#include <algorithm>
#include <cmath>

#include "drivers/simulated/building.h"
#include "slam/base/error.h"
#include "slam/geometry/angles.h"

namespace ariadne::drivers {
namespace {

constexpr double kFrameWidth = 0.06;
constexpr double kLeaf = 0.04;  // thickness of a door leaf [m]

double StartOf(const Opening& opening) { return opening.at - 0.5 * opening.width; }
double EndOf(const Opening& opening) { return opening.at + 0.5 * opening.width; }

std::vector<Opening> Sorted(const Wall& wall) {
  std::vector<Opening> openings = wall.openings;
  std::ranges::sort(openings, {}, &Opening::at);
  double end = -1e-9;
  for (const Opening& o : openings) {
    if (StartOf(o) < end) Fail("the opening at {} m overlaps its neighbour, or the wall's start", o.at);
    end = EndOf(o) - 1e-9;
    if (end > wall.length)
      Fail("the opening at {} m reaches beyond the wall's end at {} m", o.at, wall.length);
    if (o.bottom >= o.top)
      Fail("the opening at {} m has its top at {} m, not above its bottom", o.at, o.top);
    if (o.top > wall.height) Fail("the opening at {} m is higher than the wall: {} m", o.at, o.top);
  }
  return openings;
}

/// A box of the wall's thickness, and `proud` more on either side; nothing where it is empty.
void AddPiece(const Wall& wall, double x0, double x1, double z0, double z1, double proud,
              TriangleMesh& mesh) {
  const double y = 0.5 * wall.thickness + proud;
  if (x1 - x0 > 1e-9 && z1 - z0 > 1e-9) Append(mesh, BoxBetween(x0, -y, z0, x1, y, z1));
}

void AddFrame(const Wall& wall, const Opening& o, TriangleMesh& frame) {
  const double x0 = StartOf(o), x1 = EndOf(o), w = kFrameWidth;
  AddPiece(wall, x0 - 0.5 * w, x0 + 0.5 * w, o.bottom, o.top, o.frame, frame);
  AddPiece(wall, x1 - 0.5 * w, x1 + 0.5 * w, o.bottom, o.top, o.frame, frame);
  AddPiece(wall, x0 - 0.5 * w, x1 + 0.5 * w, o.top - 0.5 * w, o.top + 0.5 * w, o.frame, frame);
  if (o.bottom > 0.0) AddPiece(wall, x0, x1, o.bottom - 0.5 * w, o.bottom + 0.5 * w, o.frame, frame);
}

/// The leaf hangs flush with the face towards which it opens, and turns around its edge there.
TriangleMesh MakeLeaf(const Wall& wall, const Opening& o) {
  const double inset = o.frame > 0.0 ? 0.5 * kFrameWidth : 0.0;
  const double width = o.width - 2.0 * inset - 0.01;  // 5 mm of play on either side
  const double face = o.angle >= 0.0 ? 1.0 : -1.0, along = o.hinge == Hinge::kStart ? 1.0 : -1.0;
  const double y = face * -kLeaf;
  TriangleMesh leaf = BoxBetween(std::min(0.0, along * width), std::min(0.0, y), o.bottom + 0.01,
                                 std::max(0.0, along * width), std::max(0.0, y), o.top - inset - 0.005);
  const double hinge_x = o.hinge == Hinge::kStart ? StartOf(o) + inset + 0.005 : EndOf(o) - inset - 0.005;
  const Eigen::AngleAxisd turn(along * slam::RadFromDeg(o.angle), Eigen::Vector3d::UnitZ());
  return Moved(leaf, {Eigen::Quaterniond(turn), {hinge_x, face * 0.5 * wall.thickness, 0.0}});
}

}  // namespace

Thing Make(const Wall& wall) {
  Part masonry{"plaster", {}}, leaves{"door", {}}, frames{"door_frame", {}};
  double x = 0.0;
  for (const Opening& o : Sorted(wall)) {
    AddPiece(wall, x, StartOf(o), 0.0, wall.height, 0.0, masonry.mesh);
    AddPiece(wall, StartOf(o), EndOf(o), 0.0, o.bottom, 0.0, masonry.mesh);
    AddPiece(wall, StartOf(o), EndOf(o), o.top, wall.height, 0.0, masonry.mesh);
    x = EndOf(o);
    if (o.frame > 0.0) AddFrame(wall, o, frames.mesh);
    if (o.hinge != Hinge::kNone) Append(leaves.mesh, MakeLeaf(wall, o));
  }
  AddPiece(wall, x, wall.length, 0.0, wall.height, 0.0, masonry.mesh);
  return {std::move(masonry), std::move(leaves), std::move(frames)};
}

}  // namespace ariadne::drivers
