#include "experiments/studies/fig_01.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "experiments/render/annotations.h"
#include "experiments/render/compose.h"
#include "experiments/render/fit_camera.h"
#include "experiments/render/mesh_view.h"
#include "experiments/render/overlay.h"
#include "experiments/render/png_file.h"
#include "experiments/run/manifest.h"
#include "experiments/run/run_page.h"
#include "experiments/studies/robot_model.h"
#include "experiments/studies/tube_mesh.h"
#include "slam/geometry/angles.h"
#include "slam/scan/scan.h"

namespace ariadne::experiments {
namespace {

using Eigen::Vector3d;
using slam::TriangleMesh;

constexpr Rgb kDimension{60, 66, 76};
constexpr Rgb kBeam{206, 60, 50};
constexpr Rgb kTilt{30, 120, 84};
constexpr double kFanRadius = 0.30;  // of the beams that are drawn [m]

/// A length between two places, with what it is called.
struct Dimension {
  Vector3d from, to;
  Vector3d beside;  // towards the label [m]
  std::string label;
  double at = 0.5;  // of the label, as a share of the way
};

Camera CameraOn(const std::vector<Vector3d>& corners, const std::vector<Dimension>& dimensions,
                double azimuth, double elevation, int width) {
  std::vector<Vector3d> places = corners;
  for (const Dimension& d : dimensions) {
    places.push_back(d.from + 1.6 * d.beside);
    places.push_back(d.to + 1.6 * d.beside);
  }
  const ObliqueOptions view{.azimuth = azimuth,
                            .elevation = elevation,
                            .distance = 4.0,
                            .field_of_view = 0.5,
                            .size = {width, width * 19 / 20}};
  return Fitted(ObliqueView(Vector3d::Zero(), view), places, {.outlier_share = 0.0, .margin = width / 20});
}

void DrawDimension(Image& picture, const Camera& camera, const Dimension& d) {
  const Stroke pen{.color = kDimension, .width = std::max(1.0, picture.width / 500.0), .halo_width = 1.5};
  for (const Vector3d& end : {d.from, d.to}) {
    DrawPath(picture, camera, {end - 0.35 * d.beside, end + 0.35 * d.beside}, pen);
  }
  DrawPath(picture, camera, {d.from, d.to}, pen);
  TextStyle style = AnnotationText(picture, {});
  style.color = kDimension;
  style.halo_width = 4.0;
  const ImagePoint place = Projector(camera)(d.from + d.at * (d.to - d.from) + d.beside);
  DrawText(picture, {place.u, place.v + 0.5 * style.cap_height}, d.label, style, Align::kCenter);
}

Image ModelPanel(const TriangleMesh& mesh, const Camera& camera, const std::vector<Dimension>& dimensions,
                 std::string_view title) {
  Image picture = RenderMesh(mesh, camera, {.ambient = 0.55, .supersampling = 3}, Parallel(1));
  for (const Dimension& dimension : dimensions) DrawDimension(picture, camera, dimension);
  return WithTitle(picture, title);
}

std::string Meters(double length) { return fmt::format("{:.2f} m", length); }

std::vector<Dimension> RobotDimensions(const drivers::SimulatedRobotOptions& robot) {
  const drivers::FootprintOptions& outline = robot.base.footprint;
  const double x = 0.5 * outline.length, y = 0.5 * outline.width, aside = 0.12;
  const Vector3d axis(robot.ais.mount_x, -y - aside, robot.ais.mount_z);
  return {
      {{-x, y + aside, 0.0}, {x, y + aside, 0.0}, {0.0, aside, 0.0}, Meters(outline.length)},
      {{x + aside, -y, 0.0}, {x + aside, y, 0.0}, {aside, 0.0, 0.0}, Meters(outline.width)},
      {{-x, y + aside, 0.0}, {-x, y + aside, outline.highest}, {-0.16, 0.06, 0.0}, Meters(outline.highest)},
      {{axis.x(), axis.y(), 0.0}, axis, {0.0, -0.16, 0.0}, Meters(axis.z())}};
}

/// One slice of the scanner, as a fan of beams, and how far the mount tilts.
TriangleMesh WithBeams(TriangleMesh scanner, const Fig01Options& options) {
  const double step = slam::RadFromDeg(10.0);
  const slam::ScannerModel model{.angle_step = step};
  std::vector<Vector3d> rim;
  for (std::size_t beam = 0; beam <= 18; ++beam) {
    rim.push_back(kFanRadius * slam::BeamDirection(model, beam, options.pitch));
    const Vector3d ray[] = {0.25 * rim.back(), rim.back()};
    AppendTube(scanner, ray, 0.0007, kBeam);
  }
  AppendTube(scanner, rim, 0.0012, kBeam);
  const auto at = [](double pitch, double radius) {
    return Vector3d(radius * std::cos(pitch), 0.0, radius * std::sin(pitch));
  };
  const double low = options.robot.ais.lowest_pitch, high = options.robot.ais.highest_pitch;
  std::vector<Vector3d> arc;
  for (int i = 0; i <= 48; ++i) arc.push_back(at(low + (high - low) * i / 48.0, 0.26));
  AppendTube(scanner, arc, 0.0018, kTilt);
  for (const double limit : {low, high}) {
    const Vector3d ray[] = {at(limit, 0.10), at(limit, 0.28)};
    AppendTube(scanner, ray, 0.0012, kTilt);
  }
  return scanner;
}

Vector3d TiltLabelPlace(double pitch) { return 0.32 * Vector3d(std::cos(pitch), 0.0, std::sin(pitch)); }

void DrawTiltLabels(Image& picture, const Camera& camera, const drivers::AisScannerOptions& ais) {
  TextStyle style = AnnotationText(picture, {});
  style.halo_width = 4.0;
  style.color = kTilt;
  for (const double pitch : {ais.lowest_pitch, ais.highest_pitch}) {
    const ImagePoint place = Projector(camera)(TiltLabelPlace(pitch));
    DrawText(picture, {place.u, place.v + 0.5 * style.cap_height},
             fmt::format("{:+.0f} deg", slam::DegFromRad(pitch)), style, Align::kCenter);
  }
}

Image ScannerPanel(const Fig01Options& options) {
  const TriangleMesh mesh = WithBeams(ScannerMesh(options.pitch), options);
  const std::vector<Dimension> dimensions{
      {{0.12, -0.175, -0.16}, {0.12, 0.175, -0.16}, {0.02, 0.0, -0.05}, "0.35 m", 0.75},
      {{-0.12, 0.195, -0.14}, {0.12, 0.195, -0.14}, {0.0, 0.035, -0.01}, "0.24 m"},
      {{-0.12, 0.195, -0.14}, {-0.12, 0.195, 0.10}, {-0.03, 0.03, 0.0}, "0.24 m"}};
  std::vector<Vector3d> corners = mesh.vertices;
  for (const double pitch : {options.robot.ais.lowest_pitch, options.robot.ais.highest_pitch})
    corners.push_back(1.15 * TiltLabelPlace(pitch));
  const Camera camera = CameraOn(corners, dimensions, 0.85, 0.35, options.width);
  Image picture = RenderMesh(mesh, camera, {.ambient = 0.55, .supersampling = 3}, Parallel(1));
  for (const Dimension& dimension : dimensions) DrawDimension(picture, camera, dimension);
  DrawTiltLabels(picture, camera, options.robot.ais);
  return WithTitle(picture, "(b) The 3D scanner, a slice of its beams, and its tilt");
}

Image RobotPanel(const Fig01Options& options) {
  TriangleMesh mesh = RobotMesh(options.robot, options.pitch);
  const drivers::AisScannerOptions& ais = options.robot.ais;
  const Vector3d axis(ais.mount_x, ais.mount_y, ais.mount_z);
  const Vector3d lead[] = {axis + Vector3d(0.0, -0.14, 0.0),
                           {axis.x(), -0.5 * options.robot.base.footprint.width - 0.14, axis.z()}};
  AppendTube(mesh, lead, 0.002, kDimension);
  const std::vector<Dimension> dimensions = RobotDimensions(options.robot);
  return ModelPanel(mesh, CameraOn(mesh.vertices, dimensions, 0.75, 0.38, options.width), dimensions,
                    "(a) The robot with the 3D scanner");
}

}  // namespace

std::string RunFig01(const Fig01Options& options, const RunDirectory& run, ProgressDisplay& progress) {
  WriteManifest(run, {});
  progress.Show("models");
  WritePng(run.File("figures/fig_01.png"), Grid({RobotPanel(options), ScannerPanel(options)}));
  const drivers::FootprintOptions& outline = options.robot.base.footprint;
  const Json dimensions{{"length_m", outline.length},
                        {"width_m", outline.width},
                        {"height_m", outline.highest},
                        {"tilt_axis_m", options.robot.ais.mount_z},
                        {"track_m", options.robot.base.drive.track},
                        {"wheel_radius_m", options.robot.base.drive.wheel_radius},
                        {"safety_scanners_m", options.robot.safety.height}};
  run.WriteJson("metrics.json", dimensions);
  FinishRun(run, "Fig. 1: the robot and its scanner", 2);
  return fmt::format("{}\n", dimensions.dump());
}

}  // namespace ariadne::experiments
