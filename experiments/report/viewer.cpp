#include "experiments/report/viewer.h"

#include <fmt/format.h>

#include "experiments/report/viewer_bundle.h"
#include "experiments/report/viewer_data.h"

namespace ariadne::experiments {
namespace {

bool IsEmpty(const ViewerScene& scene) {
  return scene.stops.empty() && scene.points.empty() && scene.boxes.empty() && scene.driven.empty() &&
         scene.planned.empty() && scene.polygons.empty() && scene.mesh_map.triangles.empty();
}

std::string Bundle() {
  std::string program;
  for (const std::string_view piece : ViewerBundle()) program += piece;
  return program;
}

}  // namespace

bool HasViewer() { return !ViewerBundle().empty(); }

PageSection ViewerSection(const ViewerScene& scene, const std::string& heading,
                          const ViewerOptions& options) {
  PageSection section{heading, {}, {}, false};
  if (IsEmpty(scene)) {
    section.html = "<p>There is nothing to show in 3D: this run has no points.</p>\n";
    return section;
  }
  if (!HasViewer()) {
    section.html =
        "<p>There is no 3D view here, because the program was built without npm: install npm, and build "
        "again.</p>\n";
    return section;
  }
  const ViewerData data = EncodeScene(scene, options);
  section.html = fmt::format(
      "<div class=\"ariadne-viewer\">\n"
      "<noscript>The 3D view needs JavaScript.</noscript>\n"
      "<script type=\"application/json\" class=\"header\">{}</script>\n"
      "<script type=\"text/plain\" class=\"arrays\">{}</script>\n"
      "</div>\n<script>{}</script>\n",
      data.header, Base64(data.arrays), Bundle());
  return section;
}

}  // namespace ariadne::experiments
