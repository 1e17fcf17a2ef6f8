#pragma once

#include <span>
#include <string>
#include <vector>

#include "experiments/render/camera.h"
#include "experiments/render/image.h"
#include "slam/extract/slice_lines.h"
#include "slam/map/octree.h"
#include "slam/map/surface_model.h"

namespace ariadne::experiments {

// Pictures of what is made of points: lines, surfaces, boxes, voxels (Fig. 2, 5, 11).

/// The view of a camera at the scanner that looks ahead. `field_of_view` across the width [rad].
Camera AheadCamera(const PictureSize& size, double field_of_view);

/// The lines of all slices, those of one slice in one colour, from dark (first) to light.
Image LinesPicture(const std::vector<std::vector<slam::SpatialLine>>& lines_laser, const Camera& camera);

/// Every surface in a colour of its own, with hidden ones removed, and outlines.
Image SurfacesPicture(std::span<const slam::PlanarSurface> surfaces, const Camera& camera);

/// Surfaces in the colours of their classes, with the boxes around objects.
Image ModelPicture(const slam::SurfaceModel& model, const Camera& camera);

/// The boxes on top of another picture.
void DrawObjects(Image& canvas, const Camera& camera, std::span<const slam::ObjectBox> objects);

/// The cells as cubes, grey by reflectance where there is some, else in colours by height.
Image VoxelPicture(std::span<const slam::OctreeCell> cells, bool has_reflectance, const Camera& camera);

}  // namespace ariadne::experiments
