#pragma once

#include <vector>

#include "slam/io/stream_reader.h"
#include "slam/io/trajectory.h"

namespace ariadne::slam {

/// What ReadPoseList reads, from the rest of a file.
std::vector<NamedPose> ReadPoseList(StreamReader& reader);

}  // namespace ariadne::slam
