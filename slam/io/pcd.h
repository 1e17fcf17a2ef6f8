#pragma once

#include <istream>
#include <ostream>
#include <string>

#include "slam/io/cloud_file.h"
#include "slam/io/pcd_header.h"

namespace ariadne::slam {

/// Reads a PCD 0.7 file in any of its encodings, in metres and the axes of this project. Coordinates,
/// reflectance and normals are found by name (point_fields.h) and may have any type; other fields are
/// skipped. Points with NaN in a coordinate are directions without a measurement: they are dropped and
/// counted. HEIGHT > 1 (and WIDTH > 1) makes an organized
/// cloud, whose slices are the rows. VIEWPOINT is checked, but not
/// applied: the points stay in the frame in which they are written, and the pose of the scanner is read
/// from the files of poses. Error with line or byte for anything that is damaged.
CloudFile ReadPcd(std::istream& in, const std::string& name);

/// Writes the points, with reflectance (as `intensity`) and normals where there are, as 32-bit floats;
/// HEIGHT is the number of slices where all have the same number of points.
void WritePcd(std::ostream& out, const PointCloud& cloud, PcdEncoding encoding);

}  // namespace ariadne::slam
