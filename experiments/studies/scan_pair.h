#pragma once

#include "experiments/run/scan_source.h"
#include "slam/mapper.h"

namespace ariadne::experiments {

/// What the studies of two scans share: which scans, and how the later is aligned to the earlier.
struct ScanPairOptions {
  InputOptions input;
  slam::ScanFilterOptions scan;
  slam::ReduceOptions reduce{.method = slam::ReduceMethod::kSlices};
  slam::AlignOptions icp;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor& visit) {
    visit("input", self.input, "which scans; the first two are taken");
    visit("scan", self.scan, "which points of a scan are measurements");
    visit("reduce", self.reduce, "how the reduced points are made");
    visit("icp", self.icp, "how the second scan is aligned to the first");
  }
};

/// Two scans, filtered, and the guess of the second's pose in the first's frame.
struct ScanPair {
  std::string model_name;
  std::string data_name;
  slam::PointCloud model;
  slam::PointCloud data;
  slam::Pose3 T_model_data_guess;
  std::vector<std::filesystem::path> files;
};

/// Error where there are fewer than two scans.
ScanPair ReadScanPair(const ScanPairOptions& options);

}  // namespace ariadne::experiments
