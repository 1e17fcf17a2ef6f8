#include <gmock/gmock.h>

#include <functional>
#include <map>

#include "drivers/simulated/ais_scanner.h"
#include "drivers/simulated/solids.h"
#include "drivers/simulated/surface_distance.h"
#include "slam/geometry/angles.h"
#include "slam/map/scan_mesh.h"
#include "slam/map/voxel_mesh.h"
#include "tests/support/error_of.h"
#include "tests/support/random_room.h"

namespace ariadne::slam {
namespace {

using ::testing::HasSubstr;
using Place = std::array<long, 3>;

/// Six times the volume that the triangles enclose: positive where they look outwards.
double SixVolumes(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    sum += mesh.vertices[a].dot(mesh.vertices[b].cross(mesh.vertices[c]));
  }
  return sum;
}

/// The edges, by place, that are passed more often one way than the other.
std::size_t OpenEdges(const TriangleMesh& mesh, double grid) {
  const auto place = [&](std::uint32_t v) {
    const Eigen::Vector3d p = mesh.vertices[v] / grid;
    return Place{std::lround(p.x()), std::lround(p.y()), std::lround(p.z())};
  };
  std::map<std::pair<Place, Place>, int> passed;
  for (const auto& triangle : mesh.triangles) {
    for (int i = 0; i < 3; ++i) {
      const Place from = place(triangle[i]), to = place(triangle[(i + 1) % 3]);
      if (from < to) ++passed[{from, to}];
      if (to < from) --passed[{to, from}];
    }
  }
  return static_cast<std::size_t>(
      std::ranges::count_if(passed, [](const auto& e) { return e.second != 0; }));
}

std::vector<OctreeCell> RandomCells(std::uint64_t seed, std::size_t points) {
  RandomStream stream = NamedStream(seed, "mesh_test");
  PointCloud cloud;
  for (std::size_t i = 0; i < points; ++i) {
    cloud.positions.push_back(DrawInBox(stream, {-0.5, -0.3, 0.0}, {0.5, 0.4, 0.6}));
    cloud.reflectance.push_back(static_cast<float>(i));
  }
  Octree tree({.leaf_size = 0.1});
  tree.Add(cloud, Eigen::Vector3d::Zero());
  return tree.Cells(100);
}

TEST(VoxelMesh, EnclosesTheVoxelsWithoutHoles) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const std::vector<OctreeCell> cells = RandomCells(seed, 20 + 20 * seed);
    const TriangleMesh mesh = VoxelMesh(cells, {});
    EXPECT_NEAR(SixVolumes(mesh) / 6.0, static_cast<double>(cells.size()) * 1e-3, 1e-9);
    EXPECT_EQ(OpenEdges(mesh, 0.05), 0U);
    EXPECT_EQ(mesh.colors.size(), mesh.vertices.size());
  }
}

TEST(VoxelMesh, LeavesOutFacesBetweenNeighbours) {
  OctreeCell cell{.center = {0.5, 0.5, 0.5}, .edge = 1.0, .count = 1};
  std::vector<OctreeCell> cells{cell};
  EXPECT_EQ(VoxelMesh(cells, {}).triangles.size(), 12U);
  EXPECT_EQ(VoxelMesh(cells, {}).vertices.size(), 8U);
  cell.center.x() += 1.0;
  cells.push_back(cell);
  EXPECT_EQ(VoxelMesh(cells, {}).triangles.size(), 20U);
  cell.center = {0.75, 0.25, 1.25};  // of another size, on top
  cell.edge = 0.5;
  cells.push_back(cell);
  EXPECT_EQ(VoxelMesh(cells, {}).triangles.size(), 32U);
  EXPECT_TRUE(VoxelMesh({}, {}).triangles.empty());
  cells[0].center.z() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(ErrorOf([&] { VoxelMesh(cells, {}); }), HasSubstr("no place"));
}

TEST(VoxelMesh, ColorsByReflectanceOrHeight) {
  const OctreeCell low{.center = {0, 0, 0}, .edge = 0.1, .count = 1, .reflectance = 9};
  OctreeCell high = low, middle = low;
  high.center.z() = 2.0;
  high.reflectance = 1.0F;
  middle.center.z() = 1.0;
  middle.reflectance = std::numeric_limits<float>::quiet_NaN();
  const std::vector<OctreeCell> cells{low, middle, high};
  const TriangleMesh grey = VoxelMesh(cells, {VoxelColoring::kReflectance});
  EXPECT_EQ(grey.colors.front(), (Rgb{255, 255, 255}));
  EXPECT_EQ(grey.colors[8], (Rgb{128, 128, 128}));
  EXPECT_EQ(grey.colors.back(), (Rgb{0, 0, 0}));
  const TriangleMesh rainbow = VoxelMesh(cells, {VoxelColoring::kHeight});
  EXPECT_EQ(rainbow.colors.front(), (Rgb{0, 0, 255}));
  EXPECT_EQ(rainbow.colors[8], (Rgb{0, 255, 0}));
  EXPECT_EQ(rainbow.colors.back(), (Rgb{255, 0, 0}));
}

/// A random room, scanned from some places with all errors but the systematic one, which no mesh can know.
struct ScannedRoom {
  drivers::World world;
  std::vector<PosedCloud> scans;
};

ScannedRoom ScanRoom(std::uint64_t seed, std::size_t scans) {
  RandomStream stream = NamedStream(seed, "scan_mesh");
  const Room room = DrawRoom(stream);
  ScannedRoom scanned;
  for (const Box3& solid : room.world.solids) {
    scanned.world.bodies.push_back({"solid", drivers::MakeBox(solid), {}, {}});
  }
  const drivers::RayScene scene(scanned.world);
  drivers::AisScannerOptions options;
  options.slices = 80;
  options.range_finder.systematic = false;
  const Pose3 T_base_laser = AisMounting(options).T_base_laser;
  for (std::size_t i = 0; i < scans; ++i) {
    Pose3 T_map_base = ToPose3({DrawUniform(stream, -3.0, 3.0), Eigen::Vector2d::Zero()});
    T_map_base.translation = DrawViewpoint(stream, room) - T_map_base * T_base_laser.translation;
    const Scan scan = TakeAisScan(scene, T_map_base, 0.0, options, seed, i, Parallel(1));
    scanned.scans.push_back({"scan", ToPointCloud(scan), T_map_base * T_base_laser});
  }
  return scanned;
}

TriangleMesh InMap(const Pose3& T_map_laser, TriangleMesh mesh_laser) {
  for (Eigen::Vector3d& vertex : mesh_laser.vertices) vertex = T_map_laser * vertex;
  return mesh_laser;
}

double RmsOf(const TriangleMesh& mesh, const drivers::SurfaceDistance& truth) {
  double sum = 0.0;
  for (const Eigen::Vector3d& v : mesh.vertices) sum += std::pow(truth.Closest(v).distance, 2);
  return std::sqrt(sum / static_cast<double>(mesh.vertices.size()));
}

Eigen::Vector3d CenterOf(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& t) {
  return (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3.0;
}

double AreaOf(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Eigen::Vector3d& corner = mesh.vertices[a];
    sum += 0.5 * (mesh.vertices[b] - corner).cross(mesh.vertices[c] - corner).norm();
  }
  return sum;
}

/// Of the beams that meet a surface at less than 75 deg: which find the mesh within 5 cm of it, and which
/// find it twice.
struct Coverage {
  double once = 0.0;
  double twice = 0.0;
};

Coverage CoverageOf(const TriangleMesh& mesh, const drivers::World& truth, const PosedCloud& scan) {
  constexpr double kNear = 0.05;
  const drivers::RayScene real(truth);
  const drivers::RayScene meshed(drivers::World{"", {{"mesh", mesh, {}, {}}}, {}});
  double all = 0.0;
  Coverage coverage;
  for (std::size_t i = 0; i < scan.cloud_laser.size(); i += 3) {
    const Eigen::Vector3d& p = scan.cloud_laser.positions[i];
    drivers::Ray ray{scan.T_map_laser.translation, scan.T_map_laser.rotation * p.normalized(), 0.0};
    const drivers::Hit surface = real.Cast(ray);
    if (-surface.normal_map.dot(ray.direction_map) < std::cos(RadFromDeg(75.0))) continue;
    all += 1.0;
    const drivers::Hit hit = meshed.Cast(ray);
    if (!hit.hit() || std::abs(hit.distance - surface.distance) > kNear) continue;
    coverage.once += 1.0;
    ray.origin_map += (hit.distance + 1e-5) * ray.direction_map;
    coverage.twice += meshed.Cast(ray).distance < kNear ? 1.0 : 0.0;
  }
  return {coverage.once / all, coverage.twice / all};
}

TEST(MeshScan, IsNearerToTheSurfacesThanThePoints) {
  for (const std::uint64_t seed : {0U, 1U}) {
    const ScannedRoom room = ScanRoom(seed, 1);
    const PosedCloud& scan = room.scans[0];
    const drivers::SurfaceDistance truth(room.world);
    const TriangleMesh mesh_laser = MeshScan(scan.cloud_laser, {});
    const TriangleMesh mesh = InMap(scan.T_map_laser, mesh_laser);
    const TriangleMesh rough = InMap(scan.T_map_laser, MeshScan(scan.cloud_laser, {.smooth = false}));
    RecordProperty("rms_mm", std::to_string(1e3 * RmsOf(mesh, truth)));
    EXPECT_LT(RmsOf(mesh, truth), 0.003);
    EXPECT_LT(RmsOf(mesh, truth), 0.5 * RmsOf(rough, truth));
    EXPECT_GT(CoverageOf(mesh, room.world, scan).once, 0.94);
    EXPECT_EQ(mesh.colors.size(), mesh.vertices.size());
    std::size_t across_jumps = 0;
    for (const auto& t : mesh.triangles) across_jumps += truth.Closest(CenterOf(mesh, t)).distance > 0.06;
    EXPECT_LE(across_jumps, 5U) << "of " << mesh.triangles.size();
    for (const auto& t : mesh_laser.triangles) {
      const auto& v = mesh_laser.vertices;
      ASSERT_LT(v[t[0]].dot(v[t[1]].cross(v[t[2]])), 0.0) << "looks away from the scanner";
    }
  }
}

/// Exact ranges along the beams of a scan: 0 where nothing comes back.
PointCloud ScanOf(const std::function<double(const Eigen::Vector3d& direction)>& range, int slices = 60) {
  PointCloud cloud;
  const ScannerModel scanner{0.0, RadFromDeg(1.0)};
  for (int s = 0; s < slices; ++s) {
    cloud.slice_begin.push_back(cloud.size());
    for (std::size_t beam = 0; beam < 181; ++beam) {
      const Eigen::Vector3d direction = BeamDirection(scanner, beam, RadFromDeg(s - 45.0));
      const double r = range(direction);
      if (r > 0.0) cloud.positions.emplace_back(r * direction);
    }
  }
  return cloud;
}

double WallAt(double x, const Eigen::Vector3d& direction) {
  return direction.x() > 0.1 ? x / direction.x() : 0.0;
}

TEST(MeshScan, LeavesJumpsOpen) {
  const PointCloud cloud = ScanOf([](const Eigen::Vector3d& d) {
    const Eigen::Vector3d front = WallAt(2.5, d) * d;
    const bool on_box = d.x() > 0.1 && std::abs(front.y()) < 0.5 && std::abs(front.z()) < 0.5;
    return on_box ? front.norm() : WallAt(4.0, d);
  });
  const TriangleMesh mesh = MeshScan(cloud, {});
  std::size_t on_box = 0, on_wall = 0;
  for (const auto& t : mesh.triangles) {
    const double x = CenterOf(mesh, t).x();
    on_box += std::abs(x - 2.5) < 1e-3;
    on_wall += std::abs(x - 4.0) < 1e-3;
  }
  EXPECT_GT(on_box, 500U);
  EXPECT_GT(on_wall, 5000U);
  EXPECT_EQ(on_box + on_wall, mesh.triangles.size());
  EXPECT_TRUE(mesh.colors.empty());
}

TEST(MeshScan, FollowsTheFloorFarAway) {
  const auto floor = [](const Eigen::Vector3d& d) {
    return d.z() < -0.08 ? -1.0 / d.z() : 0.0;
  };  // to 12 m
  const TriangleMesh mesh = MeshScan(ScanOf(floor), {.max_incidence = 1.5});
  double farthest = 0.0;
  for (const Eigen::Vector3d& v : mesh.vertices) farthest = std::max(farthest, v.x());
  EXPECT_GT(farthest, 9.0);  // where slices are more than a metre apart
  EXPECT_LT(std::abs(mesh.vertices.back().z() + 1.0), 1e-3);
  double near = 0.0;
  for (const Eigen::Vector3d& v : MeshScan(ScanOf(floor), {.max_incidence = 1.3}).vertices) {
    near = std::max(near, v.norm());
  }
  EXPECT_LT(near, 1.1 / std::cos(1.3));
}

TEST(MeshScan, ClosesOverLostReturns) {
  RandomStream stream = NamedStream(1, "lost");
  const auto area_of = [&](double lost) {
    TriangleMesh mesh =
        MeshScan(ScanOf([&](const Eigen::Vector3d& d) {
                   const bool head_on = d.x() > 0.7;  // far out, two lost in a row are more than max_gap
                   return head_on && DrawUniform(stream, 0.0, 1.0) >= lost ? WallAt(3.0, d) : 0.0;
                 }),
                 {});
    return AreaOf(mesh);
  };
  const double area = area_of(0.0);
  EXPECT_NEAR(area_of(0.05), area, 0.02 * area);
}

TEST(MeshScan, DoesNotDependOnTheDirectionOfTheScan) {
  const PointCloud upwards =
      ScanOf([](const Eigen::Vector3d& d) { return WallAt(3.0 + 0.3 * d.y(), d); }, 20);
  PointCloud downwards = upwards;  // slices and beams in reverse
  std::ranges::reverse(downwards.positions);
  downwards.slice_begin.clear();
  for (auto s = upwards.slice_begin.rbegin(); s != upwards.slice_begin.rend(); ++s) {
    const std::size_t end = s == upwards.slice_begin.rbegin() ? upwards.size() : *(s - 1);
    downwards.slice_begin.push_back(upwards.size() - end);
  }
  const TriangleMesh a = MeshScan(upwards, {}), b = MeshScan(downwards, {});
  EXPECT_EQ(a.triangles.size(), b.triangles.size());
  EXPECT_NEAR(AreaOf(a), AreaOf(b), 1e-6);
}

TEST(MeshScan, RefusesWhatItCannotMesh) {
  const auto error_of = [](const std::function<void(PointCloud&)>& damage) {
    PointCloud cloud = ScanOf([](const Eigen::Vector3d& d) { return WallAt(3.0, d); }, 3);
    damage(cloud);
    return ErrorOf([&] { MeshScan(cloud, {}); });
  };
  EXPECT_THAT(error_of([](PointCloud& cloud) { cloud.slice_begin.clear(); }), HasSubstr("has no slices"));
  EXPECT_THAT(error_of([](PointCloud& cloud) { cloud.positions[7].y() = std::nan(""); }),
              HasSubstr("point 7"));
  EXPECT_THAT(error_of([](PointCloud& cloud) { cloud.positions[7].setZero(); }), HasSubstr("at the laser"));
  EXPECT_THAT(error_of([](PointCloud& cloud) { cloud.reflectance = {1.0F}; }), HasSubstr("reflectance"));
  EXPECT_THAT(ErrorOf([] { MeshScan({}, {.max_gap = 0.5}); }), HasSubstr("mesh.max_gap"));
  EXPECT_TRUE(MeshScan({}, {}).triangles.empty());
}

TEST(MeshOfScans, CoversOnceWhatSeveralHaveSeen) {
  const ScannedRoom room = ScanRoom(3, 2);
  const TriangleMesh mesh = MeshOfScans(room.scans, {});
  double area = 0.0;
  for (const PosedCloud& scan : room.scans) area += AreaOf(MeshScan(scan.cloud_laser, {}));
  EXPECT_LT(AreaOf(mesh), 0.8 * area);
  for (const PosedCloud& scan : room.scans) {
    const Coverage coverage = CoverageOf(mesh, room.world, scan);
    EXPECT_GT(coverage.once, 0.94);
    EXPECT_LT(coverage.twice, 0.05);
  }
  EXPECT_LT(RmsOf(mesh, drivers::SurfaceDistance(room.world)), 0.003);
}

TEST(MeshOfScans, TakesTheFirstOfTwoAlike) {
  const PointCloud cloud = ScanOf([](const Eigen::Vector3d& d) { return WallAt(3.0, d); }, 20);
  const std::vector<PosedCloud> twice{{"first", cloud, {}}, {"second", cloud, {}}};
  const TriangleMesh one = MeshOfScans(std::span(twice).first(1), {});
  EXPECT_EQ(MeshOfScans(twice, {}).vertices, one.vertices);
  EXPECT_EQ(one.triangles.size(), MeshScan(cloud, {}).triangles.size());
  EXPECT_TRUE(MeshOfScans({}, {}).triangles.empty());
  std::vector<PosedCloud> bad = twice;
  bad[1].cloud_laser.slice_begin.clear();
  EXPECT_THAT(ErrorOf([&] { MeshOfScans(bad, {}); }), HasSubstr("second: "));
  bad = twice;
  bad[1].T_map_laser.translation.x() = 1e7;
  EXPECT_THAT(ErrorOf([&] { MeshOfScans(bad, {}); }), HasSubstr("mesh.cell"));
}

}  // namespace
}  // namespace ariadne::slam
