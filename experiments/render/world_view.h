#pragma once

#include <limits>

#include "drivers/simulated/ray_scene.h"
#include "experiments/render/camera.h"
#include "experiments/render/color_map.h"
#include "experiments/render/image.h"
#include "slam/base/parallel.h"

namespace ariadne::experiments {

struct WorldViewOptions {
  /// The world is cut open at this height, so that one looks into its rooms; what is cut is dark. [m]
  double cut_height = std::numeric_limits<double>::infinity();
  bool color_by_height = false;  // else grey by reflectance
  ValueRange heights = {0.0, 3.0};
  double time = 0.0;  // when moving bodies are looked at [s]
  Rgb background = kWhite;
  Rgb cut = {60, 60, 66};
  int supersampling = 2;
};

/// A picture of the surfaces of a world, lit from the camera: each pixel is cast as a ray.
Image RenderWorld(const drivers::RayScene& scene, const Camera& camera, const WorldViewOptions& options,
                  const Parallel& parallel);

}  // namespace ariadne::experiments
