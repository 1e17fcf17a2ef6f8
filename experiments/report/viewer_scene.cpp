#include "experiments/report/viewer_scene.h"

namespace ariadne::experiments {

void AddScan(ViewerScene& scene, const slam::PosedCloud& scan, std::size_t step) {
  const auto stop = static_cast<std::uint32_t>(scene.stops.size());
  const slam::PointCloud& cloud_laser = scan.cloud_laser;
  const bool has_reflectance = !cloud_laser.reflectance.empty();
  scene.has_reflectance = has_reflectance && (scene.has_reflectance || scene.points.empty());
  scene.stops.push_back({scan.name, scan.T_map_laser, step});
  scene.points.reserve(scene.points.size() + cloud_laser.size());
  for (std::size_t i = 0; i < cloud_laser.size(); ++i) {
    const Eigen::Vector3d p_map = scan.T_map_laser * cloud_laser.positions[i];
    scene.points.push_back(
        {p_map.cast<float>(), has_reflectance ? cloud_laser.reflectance[i] : 0.0F, stop});
  }
}

ViewerScene SceneOf(std::span<const slam::PosedCloud> scans) {
  ViewerScene scene;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    AddScan(scene, scans[i], i);
    if (i == 0) continue;
    scene.driven.push_back({{scans[i - 1].T_map_laser.translation, scans[i].T_map_laser.translation}, i});
  }
  return scene;
}

}  // namespace ariadne::experiments
