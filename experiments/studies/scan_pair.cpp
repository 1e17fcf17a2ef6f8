#include "experiments/studies/scan_pair.h"

#include "slam/base/error.h"

namespace ariadne::experiments {

ScanPair ReadScanPair(const ScanPairOptions& options) {
  const ScanSource source(options.input);
  if (source.size() < 2) Fail("{}: two scans are needed, there is one", options.input.folder);
  const auto read = [&](std::size_t i) {
    return slam::WithinRange(source.Read(i).cloud_laser, options.scan.min_range, options.scan.max_range);
  };
  return {source.name(0),
          source.name(1),
          read(0),
          read(1),
          source.T_odom_laser(0).Inverse() * source.T_odom_laser(1),
          source.Files()};
}

}  // namespace ariadne::experiments
