#include "experiments/studies/surface_tables.h"

namespace ariadne::experiments {
namespace {

std::vector<std::string> Coordinates(const Eigen::Vector3d& p) {
  return {Exact(p.x()), Exact(p.y()), Exact(p.z())};
}

void Append(std::vector<std::string>& row, std::vector<std::string> more) {
  for (std::string& cell : more) row.push_back(std::move(cell));
}

}  // namespace

Table SurfaceTable(const slam::SurfaceModel& model) {
  Table table{{"class", "normal_x", "normal_y", "normal_z", "offset_m", "sigma_turn_rad", "sigma_offset_m",
               "area_m2", "rms_m", "points", "pieces"},
              {}};
  for (std::size_t i = 0; i < model.surfaces_map.size(); ++i) {
    const slam::PlanarSurface& surface = model.surfaces_map[i];
    const slam::Plane3 plane = slam::PlaneOf(surface);
    const Eigen::Vector3d sigma = surface.covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
    std::vector<std::string> row{std::string(NameOf(model.classes[i]))};
    Append(row, Coordinates(plane.normal));
    Append(row, {Exact(plane.offset), Exact(std::max(sigma.x(), sigma.y())), Exact(sigma.z()),
                 Exact(slam::Area(surface)), Exact(surface.rms), std::to_string(surface.points),
                 std::to_string(surface.outlines.size())});
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table ObjectTable(const slam::SurfaceModel& model) {
  Table table{{"min_x", "min_y", "min_z", "max_x", "max_y", "max_z", "surfaces", "area_m2"}, {}};
  for (const slam::ObjectBox& object : model.objects) {
    std::vector<std::string> row = Coordinates(object.box.min());
    Append(row, Coordinates(object.box.max()));
    Append(row, {std::to_string(object.surfaces.size()), Exact(object.area)});
    table.rows.push_back(std::move(row));
  }
  return table;
}

slam::SurfaceModel WithoutCeiling(const slam::SurfaceModel& model) {
  slam::SurfaceModel opened{{}, {}, model.objects};
  for (std::size_t i = 0; i < model.surfaces_map.size(); ++i) {
    if (model.classes[i] == slam::SurfaceClass::kCeiling) continue;
    opened.surfaces_map.push_back(model.surfaces_map[i]);
    opened.classes.push_back(model.classes[i]);
  }
  return opened;
}

}  // namespace ariadne::experiments
