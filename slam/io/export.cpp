#include "slam/io/export.h"

#include <algorithm>
#include <string>

#include "slam/base/error.h"

namespace ariadne::slam {
namespace {

using enum ExportFormat;
using enum ExportContent;

constexpr std::array<ExportFormatInfo, 8> kFormats{{
    {kDxf, "dxf", ".dxf", kDrawing, "points, lines and faces in layers, release 12: any CAD program"},
    {kSvg, "svg", ".svg", kPlan, "the plan to scale in layers: browsers, Inkscape"},
    {kVrml, "vrml", ".wrl", kDrawing, "VRML97: MeshLab, view3dscene, ParaView"},
    {kPly, "ply", ".ply", kMesh, "binary PLY with colours: MeshLab, CloudCompare, Blender"},
    {kGlb, "glb", ".glb", kMesh, "binary glTF 2.0: browsers, Blender, Windows and Android viewers"},
    {kBt, "bt", ".bt", kScans, "OctoMap, free and occupied: octovis, ROS octomap_server"},
    {kOt, "ot", ".ot", kScans, "OctoMap with probabilities: octovis"},
    {kPgm, "pgm", ".pgm", kGrid, "occupancy grid with a YAML file beside it: ROS map_server, nav2"},
}};

}  // namespace

std::span<const ExportFormatInfo> ExportFormats() { return kFormats; }

const ExportFormatInfo& InfoOf(ExportFormat format) { return kFormats[static_cast<std::size_t>(format)]; }

ExportFormat ExportFormatFromName(std::string_view name) {
  std::string names;
  for (const ExportFormatInfo& info : kFormats) {
    if (name == info.name || name == info.extension || name == info.extension.substr(1)) return info.format;
    names += fmt::format("{}{}", names.empty() ? "" : ", ", info.name);
  }
  Fail("there is no export format named '{}'; use one of {}", name, names);
}

}  // namespace ariadne::slam
