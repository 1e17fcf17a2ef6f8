#pragma once

#include <vector>

#include "experiments/render/image.h"

namespace ariadne::experiments {

struct GridOptions {
  int columns = 0;          // pictures per row; 0: all side by side in one row
  int gap = 24;             // between neighbours [px]
  int margin = 0;           // around all [px]
  Rgb background = kWhite;  // of gap, margin and cells that are larger than their picture
};

/// Pictures in rows and columns, each centred in its cell; a column is as wide as its widest picture and a
/// row as high as its highest.
Image Grid(const std::vector<Image>& parts, const GridOptions& options = {});

}  // namespace ariadne::experiments
