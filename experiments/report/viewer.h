#pragma once

#include <string>

#include "experiments/report/page.h"
#include "experiments/report/viewer_scene.h"

namespace ariadne::experiments {

/// How much of a scene a page holds.
struct ViewerOptions {
  std::size_t max_points = 500'000;     // 9.4 bytes each in the page
  std::size_t max_triangles = 150'000;  // of the mesh, about 20 bytes each
};

/// The section of a page with the interactive view of a scene: its data, and the program that shows it in
/// any browser with WebGL, without the network (experiments/report/web). What exceeds the options is
/// thinned, and the page says how. A sentence instead where the scene is empty, or where this program was
/// built without npm. Deterministic. Error where a coordinate is not finite, or a point's stop is missing.
PageSection ViewerSection(const ViewerScene& scene, const std::string& heading = "The map in 3D",
                          const ViewerOptions& options = {});

/// True where this program was built with the 3D view.
bool HasViewer();

}  // namespace ariadne::experiments
