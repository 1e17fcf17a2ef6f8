#include "slam/io/text_points.h"

#include <algorithm>
#include <span>

#include "slam/io/point_gatherer.h"
#include "slam/io/row_parser.h"

namespace ariadne::slam {
namespace {

std::string_view WithoutComment(std::string_view line) {
  if (line.starts_with("//")) return {};
  return line.substr(0, line.find('#'));
}

PointGatherer GathererFor(std::size_t columns) {
  PointFields fields;
  if (columns == 4) fields.reflectance = 3;
  return {fields, PointGatherer::NanPolicy::kDefect};
}

/// At most one point per line, and no line without its numbers and what separates them.
std::size_t MostPoints(const StreamReader& reader, std::optional<std::size_t> line_ends,
                       std::size_t columns) {
  const std::uint64_t bytes = reader.Remaining().value_or(0);
  return std::min<std::size_t>(line_ends.value_or(0), bytes / (2 * columns)) + 1;
}

}  // namespace

PointCloud ReadTextPoints(StreamReader& reader, const TextPointSyntax& syntax,
                          std::optional<std::size_t> line_ends) {
  RowParser parser(reader, syntax.delimiters);
  std::optional<PointGatherer> points;  // from the first point on, which tells the columns
  std::size_t columns = 0;
  while (const std::optional<std::string_view> line = reader.NextLine()) {
    const std::span<const double> row = parser.Parse(syntax.comments ? WithoutComment(*line) : *line);
    if (row.empty()) continue;
    if (!points) {
      columns = row.size();
      if (columns != 3 && columns != 4) {
        reader.FailAtLine("found {} numbers, expected x y z or x y z reflectance", columns);
      }
      points = GathererFor(columns);
      points->Reserve(MostPoints(reader, line_ends, columns));
    }
    if (row.size() != columns) {
      reader.FailAtLine("found {} numbers where the lines before have {}; complete or remove the line",
                        row.size(), columns);
    }
    if (const auto defect = points->AddRow(row)) {
      reader.FailAtLine("the point {}; remove the line", defect->problem);
    }
  }
  if (!points) Fail("{}: holds no points; expected lines of x y z", reader.name());
  return points->TakeCloud();
}

}  // namespace ariadne::slam
