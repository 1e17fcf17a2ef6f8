#pragma once

#include <array>
#include <span>
#include <string_view>

namespace ariadne::slam {

/// The formats in which a model leaves the program, beside point clouds (cloud_format.h).
enum class ExportFormat { kDxf, kSvg, kVrml, kPly, kGlb, kBt, kOt, kPgm };

/// What a format can hold, and its writer takes.
enum class ExportContent {
  kDrawing,  // a Drawing in space: WriteDxf, WriteVrml (which takes a TriangleMesh alone, too)
  kPlan,     // a Drawing seen from above: WriteSvg
  kMesh,     // a TriangleMesh: WritePlyMesh, WriteGlb
  kScans,    // clouds with the places from which they were seen: WriteOctoMap
  kGrid,     // an OccupancyGrid: WriteOccupancyGrid
};

struct ExportFormatInfo {
  ExportFormat format;
  std::string_view name;       // as a user types it
  std::string_view extension;  // with its dot
  ExportContent content;
  std::string_view description;  // what it is, and what opens it
};

/// All formats in the order of the enum.
std::span<const ExportFormatInfo> ExportFormats();

const ExportFormatInfo& InfoOf(ExportFormat format);

/// By its name, or its extension with or without the dot ("wrl" is vrml); Error with all names otherwise.
ExportFormat ExportFormatFromName(std::string_view name);

}  // namespace ariadne::slam
