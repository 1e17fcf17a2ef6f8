#include "drivers/simulated/furniture.h"

#include <algorithm>

#include "slam/base/random.h"

namespace ariadne::drivers {
namespace {

/// Four upright posts at the corners of a rectangle of 2x by 2y.
TriangleMesh MakeLegs(double x, double y, double thickness, double height) {
  TriangleMesh legs;
  const double t = 0.5 * thickness;
  for (const double sx : {-1.0, 1.0}) {
    for (const double sy : {-1.0, 1.0}) {
      const double cx = sx * (x - t), cy = sy * (y - t);
      Append(legs, BoxBetween(cx - t, cy - t, 0.0, cx + t, cy + t, height));
    }
  }
  return legs;
}

/// A row of books from one side to where the share that is filled ends.
void AddBooks(const Shelf& shelf, double board, double clearance, RandomStream& stream,
              TriangleMesh& books) {
  const double front = 0.5 * shelf.depth;
  const double end = (shelf.filled - 0.5) * shelf.length - 0.03;
  double y = -0.5 * shelf.length + 0.03;
  while (true) {
    const double thickness = DrawUniform(stream, 0.02, 0.09);
    const double height = clearance * DrawUniform(stream, 0.6, 0.92);
    const double depth = shelf.depth * DrawUniform(stream, 0.5, 0.9);
    if (y + thickness > end) return;
    Append(books,
           BoxBetween(-front + 0.02, y, board, -front + 0.02 + depth, y + thickness, board + height));
    y += thickness + 0.001;
  }
}

}  // namespace

Thing Make(const Table& table) {
  const double x = 0.5 * table.width, y = 0.5 * table.length, under = table.height - table.plate;
  const double jut = std::min(table.overhang, 0.8 * std::min(x, y));
  return {{"wood", BoxBetween(-x, -y, under, x, y, table.height)},
          {"metal", MakeLegs(x - jut, y - jut, 0.05, under)}};
}

Thing Make(const Chair& chair) {
  const double half = 0.22, seat = std::min(chair.seat, chair.height - 0.05);
  TriangleMesh cushions = BoxBetween(-half, -half, seat - 0.05, half, half, seat);
  const double back = std::max(seat + 0.02, chair.height - 0.35);
  Append(cushions, BoxBetween(-half - 0.03, -half, back, -half + 0.01, half, chair.height));
  TriangleMesh frame = MakeLegs(half, half, 0.03, seat - 0.05);
  for (const double y : {-half + 0.03, half - 0.06}) {
    Append(frame, BoxBetween(-half - 0.02, y, seat - 0.05, -half, y + 0.03, back));
  }
  return {{"cloth", std::move(cushions)}, {"metal", std::move(frame)}};
}

Thing Make(const Shelf& shelf) {
  RandomStream stream = NamedStream(shelf.seed, "world/shelf");
  const double x = 0.5 * shelf.depth, y = 0.5 * shelf.length, board = 0.02;
  TriangleMesh wood = BoxBetween(-x, -y, 0.0, x, -y + board, shelf.height);
  Append(wood, BoxBetween(-x, y - board, 0.0, x, y, shelf.height));
  Append(wood, BoxBetween(-x, -y + board, 0.0, -x + 0.01, y - board, shelf.height));
  TriangleMesh books;
  const double lowest = 0.06, step = (shelf.height - lowest - board) / (shelf.boards - 1);
  for (int i = 0; i < shelf.boards; ++i) {
    const double z = lowest + i * step;
    Append(wood, BoxBetween(-x, -y + board, z, x - 0.01, y - board, z + board));
    if (i + 1 < shelf.boards) AddBooks(shelf, z + board, step - board, stream, books);
  }
  return {{"wood", std::move(wood)}, {"paper", std::move(books)}};
}

Thing Make(const Block& block) {
  const double x = 0.5 * block.depth, y = 0.5 * block.length;
  return {{"wood", BoxBetween(-x, -y, 0.0, x, y, block.height)}};
}

Thing Make(const Cylinder& cylinder) { return {{"metal", MakeCylinder(cylinder.radius, cylinder.height)}}; }

}  // namespace ariadne::drivers
