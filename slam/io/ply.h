#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <istream>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "slam/scan/point_cloud.h"

namespace ariadne::slam {

/// Reads the element `vertex` of a PLY file, ascii or binary of either byte order, in metres and the axes
/// of this project. Coordinates, reflectance and normals are found by name (point_fields.h) and may have
/// any type; other properties and elements are skipped, but must be there. Error with line or byte for
/// anything that is damaged, and for coordinates that are NaN.
PointCloud ReadPly(std::istream& in, const std::string& name);

enum class PlyEncoding { kAscii, kBinary };

/// The properties of a vertex beside its coordinates.
struct PlyColumns {
  bool reflectance = false;
  bool normals = false;
  bool colors = false;
  bool scan_index = false;
};

/// Writes a PLY file, ascii or binary little-endian, cloud by cloud: how a map of many scans gets into a
/// file without being in memory at once. Coordinates are 32-bit floats, because that is what viewers read.
class PlyWriter {
 public:
  using Rgb = std::array<std::uint8_t, 3>;

  /// What is known of the points of a cloud beside what is in it.
  struct Labels {
    std::span<const Rgb> colors;  // one for all, or one per point
    std::int32_t scan_index = 0;
  };

  /// Writes the header for `points` points of all clouds together.
  PlyWriter(std::ostream& out, PlyEncoding encoding, const PlyColumns& columns, std::size_t points);

  /// Error where the cloud lacks a column, or there are more points than announced.
  void Add(const PointCloud& cloud, const Labels& labels);
  void Add(const PointCloud& cloud) { Add(cloud, Labels()); }

  /// Must be the last call. Error where points are missing.
  void Finish() const;

 private:
  std::ostream& out_;
  PlyEncoding encoding_;
  PlyColumns columns_;
  std::size_t points_;
  std::size_t written_ = 0;
};

/// Writes one cloud with what attributes it has.
void WritePly(std::ostream& out, const PointCloud& cloud, PlyEncoding encoding);

}  // namespace ariadne::slam
