#include "slam/io/occupancy_grid_file.h"

#include <algorithm>
#include <string>

#include "slam/base/error.h"
#include "slam/io/chunked_output.h"
#include "slam/io/file.h"

namespace ariadne::slam {
namespace {

namespace fs = std::filesystem;

/// As map_saver writes them: with the thresholds below, each is read as what it is.
std::uint8_t GrayOf(Occupancy occupancy) {
  switch (occupancy) {
    case Occupancy::kOccupied:
      return 0;
    case Occupancy::kFree:
      return 254;
    case Occupancy::kUnknown:
      break;
  }
  return 205;
}

void PutImage(std::ostream& out, const OccupancyGrid& grid) {
  ChunkedOutput pgm(out);
  pgm.Print("P5\n# ariadne: {} m per pixel\n{} {}\n255\n", grid.resolution, grid.columns, grid.rows);
  for (std::size_t row = grid.rows; row-- > 0;) {
    for (std::size_t column = 0; column < grid.columns; ++column)
      pgm.PutBytes(GrayOf(grid.At(column, row)));
  }
  pgm.Flush();
}

/// As a string of YAML in double quotes.
std::string QuotedForYaml(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + '"';
}

void PutYaml(std::ostream& out, const OccupancyGrid& grid, const std::string& image) {
  out << "image: " << QuotedForYaml(image) << '\n';
  out << fmt::format("mode: trinary\nresolution: {}\n", grid.resolution);
  out << fmt::format("origin: [{}, {}, 0.0]\n", grid.origin_map.x(), grid.origin_map.y());
  out << "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
}

void Check(const fs::path& path, const OccupancyGrid& grid) {
  if (path.extension() != ".pgm") {
    Fail("{}: cannot be written: an occupancy grid ends in .pgm", path.string());
  }
  const std::string name = path.filename().string();
  if (std::ranges::any_of(name, [](char c) { return static_cast<unsigned char>(c) < ' '; })) {
    Fail("{}: cannot be written: YAML cannot name a file with control characters", path.string());
  }
  if (grid.log_odds.empty() || grid.log_odds.size() != grid.columns * grid.rows) {
    Fail("{}: cannot be written: the grid has {} x {} cells, but {} values", path.string(), grid.columns,
         grid.rows, grid.log_odds.size());
  }
}

}  // namespace

void WriteOccupancyGrid(const fs::path& path, const OccupancyGrid& grid) {
  Check(path, grid);
  WriteFileAtomically(path, [&](std::ostream& out) { PutImage(out, grid); });
  WriteFileAtomically(fs::path(path).replace_extension(".yaml"),
                      [&](std::ostream& out) { PutYaml(out, grid, path.filename().string()); });
}

}  // namespace ariadne::slam
