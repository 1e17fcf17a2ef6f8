#pragma once

#include <filesystem>
#include <vector>

#include "experiments/run/run_directory.h"

namespace ariadne::experiments {

/// What a run has been made with: commit, compiler, libraries, processor, and the SHA-256 of each input
/// file. The same on each run by the same build on the same machine.
Json MakeManifest(const std::vector<std::filesystem::path>& inputs);

/// manifest.json. Error where one of the first `used` inputs, which a resumed run has used already, has
/// changed since.
void WriteManifest(const RunDirectory& run, const std::vector<std::filesystem::path>& inputs,
                   std::size_t used = 0);

/// In hexadecimal.
std::string Sha256OfFile(const std::filesystem::path& path);

}  // namespace ariadne::experiments
