#pragma once

#include <limits>
#include <vector>

#include "experiments/render/camera.h"
#include "experiments/render/image.h"

namespace ariadne::experiments {

/// A picture in the making: what is nearest in each pixel. Whatever can say at which depth it covers a
/// pixel (points now, the triangles of meshes later) draws into the same frame and hides what is behind it.
struct Frame {
  static constexpr float kBackground = std::numeric_limits<float>::infinity();

  Image color;
  std::vector<float> depth;  // along the camera's z, one per pixel; kBackground where nothing is [m]
  std::vector<float> grain;  // how rough the depth is: smaller steps mean nothing; 0 on exact surfaces [m]

  Frame(const Camera& camera, Rgb background)
      : color(camera.width, camera.height, background),
        depth(color.pixels.size(), kBackground),
        grain(color.pixels.size(), 0.0F) {}
};

}  // namespace ariadne::experiments
