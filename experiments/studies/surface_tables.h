#pragma once

#include "experiments/report/table.h"
#include "slam/map/surface_model.h"

namespace ariadne::experiments {

/// A row per surface: class, plane with its uncertainty, area and fit.
Table SurfaceTable(const slam::SurfaceModel& model);

/// A row per object: its box.
Table ObjectTable(const slam::SurfaceModel& model);

/// The model as pictures show it: one looks into the rooms. What the boxes say of their surfaces no longer
/// holds.
slam::SurfaceModel WithoutCeiling(const slam::SurfaceModel& model);

}  // namespace ariadne::experiments
