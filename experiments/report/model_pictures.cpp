#include "experiments/report/model_pictures.h"

#include "experiments/render/color_map.h"
#include "experiments/render/mesh_view.h"
#include "experiments/render/overlay.h"
#include "slam/map/voxel_mesh.h"

namespace ariadne::experiments {
namespace {

constexpr double kLineWidth = 1.5;     // [px]
constexpr double kOutlineWidth = 1.0;  // [px]
constexpr double kPaleness = 0.35;     // share of white in the colours of large areas
const Stroke kBoxStroke{.color = {200, 30, 30}, .width = 2.5, .halo_width = 1.0};

}  // namespace

Camera AheadCamera(const PictureSize& size, double field_of_view) {
  return LookAt(Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitZ(), field_of_view,
                size);
}

Image LinesPicture(const std::vector<std::vector<slam::SpatialLine>>& lines_laser, const Camera& camera) {
  Image picture(camera.width, camera.height, kWhite);
  for (std::size_t slice = 0; slice < lines_laser.size(); ++slice) {
    const double share = static_cast<double>(slice) / static_cast<double>(lines_laser.size());
    const Stroke stroke{.color = ColorAt(ColorMap::kSea, 0.85 * share), .width = kLineWidth};
    for (const slam::SpatialLine& line : lines_laser[slice])
      DrawPath(picture, camera, {line.from_laser, line.to_laser}, stroke);
  }
  return picture;
}

Image SurfacesPicture(std::span<const slam::PlanarSurface> surfaces, const Camera& camera) {
  slam::TriangleMesh mesh;
  for (std::size_t i = 0; i < surfaces.size(); ++i)
    slam::Append(mesh, slam::MeshOf(surfaces[i], Mix(CategoricalColor(i), kWhite, kPaleness)));
  return RenderMesh(mesh, camera, {}, Parallel(1));
}

Image ModelPicture(const slam::SurfaceModel& model, const Camera& camera) {
  Image picture = RenderMesh(slam::MeshOf(model), camera, {}, Parallel(1));
  DrawObjects(picture, camera, model.objects);
  return picture;
}

void DrawObjects(Image& canvas, const Camera& camera, std::span<const slam::ObjectBox> objects) {
  for (const slam::ObjectBox& object : objects) DrawBox(canvas, camera, object.box, kBoxStroke);
}

Image VoxelPicture(std::span<const slam::OctreeCell> cells, bool has_reflectance, const Camera& camera) {
  const slam::VoxelMeshOptions options{has_reflectance ? slam::VoxelColoring::kReflectance
                                                       : slam::VoxelColoring::kHeight};
  return RenderMesh(slam::VoxelMesh(cells, options), camera, {}, Parallel(1));
}

}  // namespace ariadne::experiments
