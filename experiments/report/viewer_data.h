#pragma once

#include <string>
#include <string_view>

#include "experiments/report/viewer.h"

namespace ariadne::experiments {

/// A scene as a page holds it: what is small as JSON, and the arrays one after another, little-endian:
/// triangles (3 uint32), points and then vertices of the mesh (3 uint16 each, from 0 at the lower to 65535
/// at the upper end of the JSON's box), reflectance of the points (uint8), colours of the vertices (3
/// uint8). Points stand in the order of the stops, stops in the order of their steps. See
/// web/src/decode.js.
struct ViewerData {
  std::string header;  // JSON, which may stand within HTML
  std::string arrays;
};

/// Error where something is not within 1000 km, or a point's stop is missing.
ViewerData EncodeScene(const ViewerScene& scene, const ViewerOptions& options);

/// RFC 4648, with padding.
std::string Base64(std::string_view bytes);

}  // namespace ariadne::experiments
