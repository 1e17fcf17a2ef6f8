#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "slam/geometry/pose3.h"
#include "slam/registration/options.h"
#include "slam/search/surface.h"

namespace ariadne::slam {

/// Whether two points were seen from opposite sides of what they lie on, by normals that face the scanners;
/// a point without a normal may be from any.
bool AreOpposite(const SurfacePoint& model, const SurfacePoint& data, const Eigen::Matrix3d& R_model_data);

/// Which pairs may count, by the surfaces on which their points lie, at a pose. Refers to the surfaces, of
/// which there is one per point where the options need them (NeedsModelSurfaces, NeedsDataSurfaces).
class PairFilter {
 public:
  PairFilter(const std::vector<SurfacePoint>& model, const std::vector<SurfacePoint>& data,
             const Pose3& T_model_data, const AlignOptions& options);

  /// The metric has its normals; with skip_boundary the model does not end there; with one_sided both
  /// points were not seen from opposite sides.
  bool Keeps(std::size_t data_index, std::uint32_t model_index) const;

 private:
  const std::vector<SurfacePoint>& model_;
  const std::vector<SurfacePoint>& data_;
  Eigen::Matrix3d R_model_data_;
  const AlignOptions& options_;
};

}  // namespace ariadne::slam
