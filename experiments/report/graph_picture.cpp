#include "experiments/report/graph_picture.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "experiments/render/compose.h"
#include "experiments/render/draw.h"
#include "experiments/render/fit_camera.h"
#include "experiments/render/scales.h"

namespace ariadne::experiments {
namespace {

using Positions = std::vector<Eigen::Vector3d>;

constexpr PictureSize kPanel{1400, 1050};
constexpr Rgb kOdometryColor{40, 44, 52};
constexpr Rgb kClosureColor{46, 118, 190};
constexpr Rgb kRejectedColor{214, 64, 40};
constexpr double kRejectedWeight = 0.5;  // edges below count as turned off

/// Azimuth of the eye [rad] from which the longest horizontal extent lies across the picture.
double BroadsideAzimuth(const Positions& positions) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const Eigen::Vector3d& p : positions) mean += p.head<2>() / static_cast<double>(positions.size());
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const Eigen::Vector3d& p : positions) {
    const Eigen::Vector2d offset = p.head<2>() - mean;
    spread += offset * offset.transpose();
  }
  const Eigen::Vector2d longest =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(spread).eigenvectors().col(1);
  const double azimuth = std::atan2(longest.y(), longest.x()) - 0.5 * std::numbers::pi;
  // Of the two sides the one towards -y, as on maps; and a little askew, so that grids do not hide rows.
  return (std::sin(azimuth) > 0.0 ? azimuth + std::numbers::pi : azimuth) + 0.3;
}

Camera GraphCamera(const DrawnGraph& graph, const Positions& positions, double azimuth) {
  const ObliqueOptions oblique{.projection = Camera::Projection::kOrthographic,
                               .azimuth = azimuth,
                               .elevation = 0.55,
                               .size = kPanel};
  const Camera camera = graph.planar ? TopView(kPanel) : ObliqueView(Eigen::Vector3d::Zero(), oblique);
  return Fitted(camera, positions, {.outlier_share = 0.0, .margin = 50});
}

std::vector<Polyline> LinesOf(const DrawnGraph& graph, const Polyline& points, bool closure,
                              bool rejected) {
  std::vector<Polyline> lines;
  for (const DrawnGraph::Edge& edge : graph.edges) {
    if (edge.closure != closure || (edge.weight < kRejectedWeight) != rejected) continue;
    lines.push_back({points[edge.from], points[edge.to]});
  }
  return lines;
}

Image Panel(const DrawnGraph& graph, const Positions& positions, double azimuth, const std::string& title) {
  const Camera camera = GraphCamera(graph, positions, azimuth);
  const Projector project(camera);
  Polyline points;
  for (const Eigen::Vector3d& p : positions) {
    const ImagePoint point = project(p);
    points.emplace_back(point.u, point.v);
  }
  Image canvas(camera.width, camera.height);
  DrawPolylines(canvas, LinesOf(graph, points, true, true),
                {.color = kRejectedColor, .width = 1.0, .opacity = 0.35});
  DrawPolylines(canvas, LinesOf(graph, points, true, false),
                {.color = kClosureColor, .width = 1.2, .opacity = 0.6});
  DrawPolylines(canvas, LinesOf(graph, points, false, false), {.color = kOdometryColor, .width = 2.0});
  return WithScaleBar(WithTitle(canvas, title), camera);
}

std::vector<LegendEntry> Legend(const DrawnGraph& graph) {
  const auto count = [&](bool closure, bool rejected) {
    return std::ranges::count_if(graph.edges, [&](const DrawnGraph::Edge& edge) {
      return edge.closure == closure && (edge.weight < kRejectedWeight) == rejected;
    });
  };
  std::vector<LegendEntry> entries{{fmt::format("{} odometry edges", count(false, false)), kOdometryColor},
                                   {fmt::format("{} closures", count(true, false)), kClosureColor}};
  if (const auto rejected = count(true, true); rejected > 0) {
    entries.push_back({fmt::format("{} rejected closures", rejected), kRejectedColor});
  }
  return entries;
}

}  // namespace

Image GraphPicture(const DrawnGraph& graph, const Positions& before_map, const Positions& after_map,
                   const std::string& title_before, const std::string& title_after) {
  const double azimuth = graph.planar ? 0.0 : BroadsideAzimuth(after_map);
  const Image both = Grid(
      {Panel(graph, before_map, azimuth, title_before), Panel(graph, after_map, azimuth, title_after)});
  return WithLegend(both, Legend(graph), {.cap_height = 22.0});
}

}  // namespace ariadne::experiments
