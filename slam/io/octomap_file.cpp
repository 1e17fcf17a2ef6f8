#include "slam/io/octomap_file.h"

#define OCTOMAP_NODEBUGOUT  // its headers would print in a debug build
#include <octomap/OcTree.h>
#include <octomap/Pointcloud.h>

#include <algorithm>

#include "slam/base/error.h"
#include "slam/io/file.h"

namespace ariadne::slam {
namespace {

namespace fs = std::filesystem;

constexpr double kCellsToEachSide = 32768.0;  // keys of a cell have 16 bits

/// Debian's library is built for the baseline instruction set: nothing but its own plain types crosses.
octomap::point3d ToOctoMap(const Eigen::Vector3d& p) {
  return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
}

void CheckReach(const Eigen::Vector3d& p_map, const PosedCloud& scan, const OctoMapOptions& options,
                const fs::path& path) {
  const double reach = (kCellsToEachSide - 1.0) * options.resolution;
  if (p_map.allFinite() && p_map.cwiseAbs().maxCoeff() < reach) return;
  Fail(
      "{}: cannot be written: scan '{}' has a place at ({}, {}, {}) m; it must be finite and within {} m "
      "of "
      "the origin, or the cells larger",
      path.string(), scan.name, p_map.x(), p_map.y(), p_map.z(), reach);
}

octomap::Pointcloud PointsInMap(const PosedCloud& scan, const OctoMapOptions& options,
                                const fs::path& path) {
  octomap::Pointcloud points;
  points.reserve(scan.cloud_laser.size());
  for (const Eigen::Vector3d& p_laser : scan.cloud_laser.positions) {
    const Eigen::Vector3d p_map = scan.T_map_laser * p_laser;
    CheckReach(p_map, scan, options, path);
    points.push_back(ToOctoMap(p_map));
  }
  return points;
}

void Insert(octomap::OcTree& tree, const PosedCloud& scan, const OctoMapOptions& options,
            const fs::path& path) {
  constexpr bool kLater = true, kOneBeamPerCell = true;
  CheckReach(scan.T_map_laser.translation, scan, options, path);
  const double max_range = options.max_range > 0.0 ? options.max_range : -1.0;
  tree.insertPointCloud(PointsInMap(scan, options, path), ToOctoMap(scan.T_map_laser.translation),
                        max_range, kLater, kOneBeamPerCell);
}

/// The file that OctoMap's own writers make; those print to the terminal.
void PutTree(std::ostream& out, const octomap::OcTree& tree, bool binary) {
  out << "# Octomap OcTree " << (binary ? "binary " : "") << "file\n";  // readers look for this line
  out << "# ariadne: metres, z up\n";
  out << fmt::format("id OcTree\nsize {}\nres {}\ndata\n", tree.size(), tree.getResolution());
  if (binary) {
    tree.writeBinaryData(out);
  } else {
    tree.writeData(out);
  }
}

}  // namespace

void WriteOctoMap(const fs::path& path, std::span<const PosedCloud> scans, const OctoMapOptions& options) {
  CheckOptions(options, "octomap.");
  const std::string extension = path.extension().string();
  if (extension != ".bt" && extension != ".ot") {
    Fail("{}: cannot be written: an OctoMap ends in .bt (free or occupied) or .ot (probabilities)",
         path.string());
  }
  if (std::ranges::all_of(scans, [](const PosedCloud& scan) { return scan.cloud_laser.empty(); })) {
    Fail("{}: cannot be written: the scans have no points", path.string());
  }
  octomap::OcTree tree(options.resolution);
  for (const PosedCloud& scan : scans) Insert(tree, scan, options, path);
  tree.updateInnerOccupancy();
  const bool binary = extension == ".bt";
  if (binary) tree.toMaxLikelihood();
  tree.prune();
  WriteFileAtomically(path, [&](std::ostream& out) { PutTree(out, tree, binary); });
}

}  // namespace ariadne::slam
