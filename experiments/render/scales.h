#pragma once

#include <string_view>

#include "experiments/render/annotations.h"
#include "experiments/render/camera.h"
#include "experiments/render/color_map.h"
#include "experiments/render/image.h"

namespace ariadne::experiments {

/// The picture over a bar of 1, 2 or 5 times a power of ten metres, at most a quarter of the width. Only an
/// orthographic picture has a scale; another is an Error.
Image WithScaleBar(const Image& picture, const Camera& camera, const AnnotationOptions& options = {});

/// The same bar inside of the picture, in its lower left corner, on a ground of the background's colour.
void DrawScaleBar(Image& canvas, const Camera& camera, const AnnotationOptions& options = {});

/// The picture over the colours of a map, with the values at both ends and in the middle, and the name of
/// the quantity with its unit: "height [m]".
Image WithColorBar(const Image& picture, ColorMap map, const ValueRange& range, std::string_view quantity,
                   const AnnotationOptions& options = {});

/// The largest of ..., 0.5, 1, 2, 5, 10, 20, ... that is not above a positive value.
double RoundNumberBelow(double value);

}  // namespace ariadne::experiments
