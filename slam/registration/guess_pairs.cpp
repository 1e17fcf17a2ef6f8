#include "slam/registration/guess_pairs.h"

namespace ariadne::slam {

GuessPairs PairsOfGuess(const Pose3& T_model_data_guess, double length) {
  GuessPairs pairs;
  for (std::size_t k = 0; k < pairs.data.size(); ++k) {
    const double way = k % 2 == 0 ? length : -length;
    pairs.data[k] = way * Eigen::Vector3d::Unit(static_cast<Eigen::Index>(k / 2));
    pairs.model[k] = T_model_data_guess * pairs.data[k];
  }
  return pairs;
}

}  // namespace ariadne::slam
