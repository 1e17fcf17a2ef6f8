#include "experiments/report/map_pictures.h"

#include "experiments/render/colored_points.h"
#include "experiments/render/density_view.h"
#include "experiments/render/fit_camera.h"
#include "experiments/render/overlay.h"
#include "experiments/render/point_view.h"
#include "experiments/render/scales.h"
#include "experiments/report/map_cameras.h"

namespace ariadne::experiments {
namespace {

using Scans = std::vector<slam::PosedCloud>;

constexpr std::size_t kMaxLegend = 20;  // more scans than categorical colours cannot be told apart

std::vector<slam::Pose3> Poses(const Scans& scans) {
  std::vector<slam::Pose3> T_map_laser;
  for (const slam::PosedCloud& scan : scans) T_map_laser.push_back(scan.T_map_laser);
  return T_map_laser;
}

std::vector<LegendEntry> Legend(const Scans& scans) {
  std::vector<LegendEntry> entries;
  for (std::size_t i = 0; i < scans.size(); ++i) entries.push_back({scans[i].name, CategoricalColor(i)});
  return entries;
}

}  // namespace

Image PlainTopPicture(const Scans& scans, const Scans& frame, const std::string& title) {
  const Camera camera = TopCamera(frame);
  return WithScaleBar(WithTitle(RenderDensity(ColoredByScan(scans), camera), title), camera);
}

Image TopPicture(const Scans& scans, const Scans& frame, const std::string& title) {
  const Camera camera = TopCamera(frame);
  Image picture = RenderDensity(ColoredByScan(scans), camera);
  DrawPoses(picture, camera, Poses(scans));
  const Image finished = WithScaleBar(WithTitle(picture, title), camera);
  return scans.size() <= kMaxLegend ? WithLegend(finished, Legend(scans)) : finished;
}

Image ObliquePicture(const Scans& scans, const std::string& title) {
  const Camera camera = ObliqueCamera(scans);
  const std::vector<Eigen::Vector3d> positions_map = PositionsInMap(scans, WithoutCeiling(scans));
  const ValueRange heights = HeightRange(positions_map);
  Image picture = RenderPoints(ColoredByHeight(positions_map, heights), camera);
  std::vector<Eigen::Vector3d> path;
  for (const slam::PosedCloud& scan : scans) path.push_back(scan.T_map_laser.translation);
  DrawPath(picture, camera, path);
  DrawPoses(picture, camera, Poses(scans));
  return WithColorBar(WithTitle(picture, title), ColorMap::kShore, heights, "height [m]");
}

Image ScanObliquePicture(const Scans& scans, const Scans& frame, const std::string& title) {
  const ColoredPoints points = Lightened(ColoredByScan(scans, WithoutCeiling(frame)));
  return WithTitle(RenderPoints(points, ObliqueCamera(frame)), title);
}

Image ScanPicture(const slam::PosedCloud& scan, const slam::PosedCloud& frame, double radius,
                  const std::string& title) {
  const ValueRange heights = HeightRange(PositionsInMap({frame}));
  const ObliqueOptions behind{.azimuth = 3.0, .elevation = 0.45};
  const Camera camera = Fitted(ObliqueView(Eigen::Vector3d::Zero(), behind), PositionsInMap({frame}),
                               {.adjust_height = true});
  const PointViewOptions options{.splats = {.min_radius = radius, .max_radius = radius}};
  return WithTitle(RenderPoints(ColoredByHeight(PositionsInMap({scan}), heights), camera, options), title);
}

}  // namespace ariadne::experiments
