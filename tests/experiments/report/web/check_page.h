#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>

#include "experiments/report/viewer.h"

namespace ariadne::experiments {

/// What keeps a test from opening a page in a browser; empty: nothing.
inline std::string NoBrowser() {
  if (!HasViewer()) return "the program was built without npm";
  if (std::system("command -v node >/dev/null") != 0) return "node is not installed";
  return "";
}

/// Opens a page with a 3D view in headless Chromium and tries all that is on it: check_page.mjs. Skips the
/// test where there is no browser; what is wrong stands in the output.
inline void CheckPageInBrowser(const std::filesystem::path& page) {
  const std::string command =
      "node '" ARIADNE_SOURCE_DIR "/tests/experiments/report/web/check_page.mjs' '" + page.string() + "'";
  const int status = std::system(command.c_str());
  if (WIFEXITED(status) && WEXITSTATUS(status) == 77) GTEST_SKIP() << "chromium is not installed";
  EXPECT_EQ(status, 0);
}

}  // namespace ariadne::experiments
