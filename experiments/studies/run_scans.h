#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "experiments/studies/register_options.h"

namespace ariadne::experiments {

/// The scans of a run of `register`, read one at a time, at the poses that it has come to.
class RunScans {
 public:
  /// Error where the directory holds no finished run of `register`, or its scans are not there any more.
  explicit RunScans(const std::filesystem::path& run);

  std::size_t size() const { return T_map_laser_.size(); }
  /// The points within the run's range.
  slam::PosedCloud Read(std::size_t i) const;
  const RegisterOptions& options() const { return options_; }
  const ScanSource& source() const { return source_; }

 private:
  RegisterOptions options_;
  ScanSource source_;
  std::vector<slam::Pose3> T_map_laser_;
};

/// All of them at once, and where a simulated one was really taken.
struct RegisteredMap {
  std::vector<slam::PosedCloud> scans;
  InputOptions input;
  std::optional<slam::Pose3> T_world_master;
};

RegisteredMap ReadRegisteredMap(const std::filesystem::path& run);

}  // namespace ariadne::experiments
