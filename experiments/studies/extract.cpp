#include "experiments/studies/extract.h"

#include <fmt/format.h>

#include "experiments/render/png_file.h"
#include "experiments/report/map_cameras.h"
#include "experiments/report/model_pictures.h"
#include "experiments/run/manifest.h"
#include "experiments/run/run_page.h"
#include "experiments/studies/surface_tables.h"
#include "slam/base/stopwatch.h"
#include "slam/io/cloud_io.h"
#include "slam/io/dxf.h"

namespace ariadne::experiments {
namespace {

using SliceLines = std::vector<std::vector<slam::SpatialLine>>;

/// What is found in one scan; in the map frame of its odometry, which is level.
struct ExtractedScan {
  SliceLines lines_laser;  // empty without slices
  slam::PointCloud edges_map;
  slam::SurfaceModel model;
};

std::size_t CountOf(const SliceLines& lines) {
  std::size_t count = 0;
  for (const auto& of_slice : lines) count += of_slice.size();
  return count;
}

ExtractedScan Extract(const slam::PosedCloud& scan, const slam::SurfaceModelOptions& options) {
  ExtractedScan extracted;
  if (scan.cloud_laser.organized()) {
    extracted.lines_laser = slam::SliceLines(scan.cloud_laser, options.extract.lines);
    extracted.edges_map =
        slam::Transformed(scan.T_map_laser, slam::EdgePointCloud(scan.cloud_laser, options.extract.lines));
  }
  extracted.model = slam::MakeSurfaceModel(slam::SurfacesInMap(scan, options.extract), options);
  return extracted;
}

slam::Drawing DrawingOf(const ExtractedScan& extracted, const slam::Pose3& T_map_laser) {
  slam::Drawing drawing = slam::DrawingOf(extracted.model);
  slam::DrawingLayer lines{"lines", {40, 90, 160}, {}, {}, {}};
  for (const auto& of_slice : extracted.lines_laser) {
    for (const slam::SpatialLine& line : of_slice)
      lines.lines.push_back({{T_map_laser * line.from_laser, T_map_laser * line.to_laser}, false});
  }
  drawing.layers.push_back(std::move(lines));
  drawing.layers.push_back({"edge_points", {120, 40, 160}, extracted.edges_map.positions, {}, {}});
  return drawing;
}

/// The files of a scan: its drawing, its edge points, and its picture.
void WriteScan(const slam::PosedCloud& scan, const ExtractedScan& extracted, bool figures,
               const RunDirectory& run) {
  slam::WriteDxf(run.File("drawings/" + scan.name + ".dxf"), DrawingOf(extracted, scan.T_map_laser));
  if (!extracted.edges_map.empty())
    slam::WriteCloud(run.File("edges/" + scan.name + ".ply"), extracted.edges_map);
  if (figures && !extracted.model.surfaces_map.empty())
    WritePng(run.File("figures/" + scan.name + ".png"),
             ModelPicture(WithoutCeiling(extracted.model), ObliqueCamera({scan})));
}

void AddRows(Table& table, const std::string& name, const Table& rows) {
  if (table.columns.empty()) {
    table.columns = rows.columns;
    table.columns.insert(table.columns.begin(), "scan");
  }
  for (std::vector<std::string> row : rows.rows) {
    row.insert(row.begin(), name);
    table.rows.push_back(std::move(row));
  }
}

}  // namespace

std::string RunExtract(const ExtractOptions& options, const RunDirectory& run, ProgressDisplay& progress) {
  const ScanSource source(options.input);
  WriteManifest(run, source.Files());
  Table scans{{"scan", "points", "slices", "lines", "edge_points", "surfaces", "objects"}, {}};
  Table surfaces, objects;
  Json seconds = Json::array();
  for (std::size_t i = 0; i < source.size(); ++i) {
    run.WriteProgress("running", i, source.size());
    progress.Show(fmt::format("{} ({} of {}, {})", source.name(i), i + 1, source.size(),
                              progress.Eta(static_cast<double>(i) / static_cast<double>(source.size()))));
    slam::PosedCloud scan = source.Read(i);
    scan.cloud_laser = slam::WithinRange(scan.cloud_laser, options.scan.min_range, options.scan.max_range);
    const Stopwatch watch;
    const ExtractedScan extracted = Extract(scan, options.surfaces);
    seconds.push_back(watch.Seconds());
    WriteScan(scan, extracted, options.figures, run);
    scans.rows.push_back({scan.name, std::to_string(scan.cloud_laser.size()),
                          std::to_string(scan.cloud_laser.slice_begin.size()),
                          std::to_string(CountOf(extracted.lines_laser)),
                          std::to_string(extracted.edges_map.size()),
                          std::to_string(extracted.model.surfaces_map.size()),
                          std::to_string(extracted.model.objects.size())});
    AddRows(surfaces, scan.name, SurfaceTable(extracted.model));
    AddRows(objects, scan.name, ObjectTable(extracted.model));
  }
  run.WriteCsv("scans.csv", scans);
  run.WriteCsv("surfaces.csv", surfaces);
  run.WriteCsv("objects.csv", objects);
  run.WriteJson("timing.json", {{"extract_s", seconds}});
  FinishRun(run, "Lines, surfaces and objects of each scan", source.size());
  return ToText(scans);
}

}  // namespace ariadne::experiments
