#pragma once

// OMPL, as this program uses it: with random numbers of its own streams, and without output. For .cpp files
// only; no header that others include shows OMPL.

#include <ompl/base/MotionValidator.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/StateSampler.h>
#include <ompl/base/StateValidityChecker.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/util/Console.h>

#include <cstdint>
#include <memory>
#include <string_view>

#include "planning/path/free_space.h"
#include "slam/base/random.h"
#include "slam/geometry/pose2.h"

namespace ariadne::planning::internal {

/// OMPL writes to the terminal unless told not to; the last of these that ends restores what was before.
class OmplSilence {
 public:
  OmplSilence();
  ~OmplSilence();
  OmplSilence(const OmplSilence&) = delete;
  OmplSilence& operator=(const OmplSilence&) = delete;
};

/// Error for a disc's radius that is negative or not finite.
void RequireRadius(double radius);

/// A seed for one of OMPL's generators, which have 32 bits; of a named stream.
std::uint_fast32_t OmplSeed(std::uint64_t seed, std::string_view name);

/// A pose as a state, whose yaw must be below pi: OMPL asserts it.
void SetState(const slam::Pose2& T_map_robot, ompl::base::State* state);
slam::Pose2 PoseOf(const ompl::base::State* state);

/// The bounds of the free space's raster.
ompl::base::RealVectorBounds BoundsOf(const FreeSpace& space);

/// The plane in which a disc moves: valid where it is free, with the clearance that is left over.
/// Samplers draw from streams of the seed, one per sampler that OMPL makes, in the order in which it does:
/// OMPL's own generators are numbered over the life of the program.
ompl::base::SpaceInformationPtr PlaneOfDisc(const FreeSpace& space, double radius, std::uint64_t seed);

Eigen::Vector2d PlaceOf(const ompl::base::State* state);

}  // namespace ariadne::planning::internal
