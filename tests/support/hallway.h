#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <vector>

#include "slam/io/scan_folder.h"

namespace ariadne::slam {

/// The real scans of a hallway (3DTK's dat/): in ARIADNE_DATA, or in ../shared/data beside the sources.
inline std::filesystem::path HallwayFolder() {
  const char* const data = std::getenv("ARIADNE_DATA");
  const std::filesystem::path beside = std::filesystem::path(ARIADNE_SOURCE_DIR) / "../shared/data";
  return (data != nullptr ? std::filesystem::path(data) : beside) / "scans/hallway";
}

/// The fixture of tests that need them; skips where they are missing.
class HallwayTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(HallwayFolder())) {
      GTEST_SKIP() << HallwayFolder() << " is missing; set ARIADNE_DATA to the folder with scans/";
    }
  }

  /// The three scans at the poses of their files, without what the scanner did not see (0.5 m to 32 m).
  static const std::vector<PosedCloud>& Scans() {
    static const std::vector<PosedCloud> scans = [] {
      std::vector<PosedCloud> read = ReadScanFolder(HallwayFolder()).scans;
      for (PosedCloud& scan : read) scan.cloud_laser = WithinRange(scan.cloud_laser, 0.5, 32.0);
      return read;
    }();
    return scans;
  }
};

}  // namespace ariadne::slam
