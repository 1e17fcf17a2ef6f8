#pragma once

#include <array>
#include <filesystem>

#include "drivers/simulated/load_world.h"
#include "experiments/render/image.h"
#include "slam/base/options.h"

namespace ariadne::experiments {

enum class ViewFrom { kTop, kOblique, kScanner };
enum class ViewColor { kScan, kHeight, kReflectance, kError };

/// How `ariadne view` looks at a map or at a world.
struct ViewOptions {
  ViewFrom from = ViewFrom::kOblique;
  ViewColor color = ViewColor::kHeight;
  int scan = 0;
  double cut_height = 1.9;
  int width = 1600;
  drivers::WorldOptions geometry;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("from", self.from, "above (to scale), at an angle, or as one of the scanners looked ahead");
    visit("color", self.color, "of points: by scan, height, reflectance or distance from the true surface");
    visit("scan", self.scan, Unit(""), Range{0, 1e9}, "whose scanner, with from=scanner");
    visit("cut_height", self.cut_height, Unit("m"), Range{-1e3, 1e3},
          "at which worlds are cut open; below the lintels of doors");
    visit("width", self.width, Unit("px"), Range{64, 16384}, "of the picture");
    visit("geometry", self.geometry, "what floor plans and meshes leave open");
  }
};

/// The map of a run of `register`, with the robot's path.
Image ViewRun(const std::filesystem::path& run, const ViewOptions& options);

/// A world, from above or at an angle.
Image ViewWorld(const std::string& source, const ViewOptions& options);

}  // namespace ariadne::experiments

namespace ariadne {

template <>
struct EnumNames<experiments::ViewFrom> {
  static constexpr std::array<std::string_view, 3> value{"top", "oblique", "scanner"};
};

template <>
struct EnumNames<experiments::ViewColor> {
  static constexpr std::array<std::string_view, 4> value{"scan", "height", "reflectance", "error"};
};

}  // namespace ariadne
