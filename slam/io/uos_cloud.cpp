#include "slam/io/uos_cloud.h"

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "slam/io/chunked_output.h"
#include "slam/io/row_parser.h"
#include "slam/io/text_points.h"
#include "slam/io/uos_axes.h"
#include "slam/io/writable.h"

namespace ariadne::slam {
namespace {

struct GridSize {
  std::uint64_t rows = 0;
  std::uint64_t columns = 0;
};

/// "226 x 360"
std::optional<GridSize> ParseHeader(std::string_view line) {
  const std::vector<std::string_view> words = SplitAtBlanks(line);
  if (words.size() != 3 || words[1] != "x") return std::nullopt;
  const auto rows = ParseCount(words[0]);
  const auto columns = ParseCount(words[2]);
  if (!rows || !columns) return std::nullopt;
  return GridSize{*rows, *columns};
}

/// None where the header speaks of another number of points: a filter has removed some since.
std::vector<std::size_t> Slices(const GridSize& grid, std::size_t points) {
  const bool fits = grid.columns != 0 && points % grid.columns == 0 && points / grid.columns == grid.rows;
  std::vector<std::size_t> begins;
  for (std::size_t begin = 0; fits && begin < points; begin += grid.columns) begins.push_back(begin);
  return begins;
}

}  // namespace

PointCloud ReadUosCloud(std::istream& in, const std::string& name) {
  const auto line_ends = CountLineEnds(in);
  StreamReader reader(in, name);
  const auto header = ParseHeader(reader.PeekLine().value_or(""));
  if (header) reader.NextLine();
  PointCloud cloud = ReadTextPoints(reader, {}, line_ends);
  for (Eigen::Vector3d& p : cloud.positions) p = FromUosPoint(p);
  if (header) cloud.slice_begin = Slices(*header, cloud.size());
  return cloud;
}

void WriteUosCloud(std::ostream& out, const PointCloud& cloud_laser) {
  CheckWritableWithPoints(cloud_laser);
  ChunkedOutput output(out);
  if (const auto columns = GridColumns(cloud_laser)) {
    output.Print("{} x {}\n", cloud_laser.slice_begin.size(), *columns);
  }
  for (std::size_t i = 0; i < cloud_laser.size(); ++i) {
    // 12 digits: the conversion of the unit disturbs the last ones of a double.
    const Eigen::Vector3d p_uos = ToUosPoint(cloud_laser.positions[i]).array() + 0.0;  // no -0
    output.Print("{:.12g} {:.12g} {:.12g}", p_uos.x(), p_uos.y(), p_uos.z());
    if (!cloud_laser.reflectance.empty()) output.Print(" {}", cloud_laser.reflectance[i]);
    output.Print("\n");
  }
  output.Flush();
}

}  // namespace ariadne::slam
