#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <string_view>

#include "slam/scan/point_cloud.h"
#include "tests/support/error_of.h"

namespace ariadne::slam::testing_support {

namespace fs = std::filesystem;

/// A folder of its own for a test, which disappears with it.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (fs::temp_directory_path() / "ariadne_test.XXXXXX").string();
    path_ = fs::path(mkdtemp(name.data())) / "folder";  // whose parent is empty, too
    fs::create_directory(path_);
  }
  ~TemporaryFolder() { fs::remove_all(path_.parent_path()); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const fs::path& path() const { return path_; }
  fs::path operator/(std::string_view name) const { return path_ / name; }

  /// Writes a file, with the folders on its way.
  fs::path Write(std::string_view name, std::string_view content) const {
    fs::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name, std::ios::binary) << content;
    return path_ / name;
  }

 private:
  fs::path path_;
};

inline std::string ContentOf(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

using ariadne::ErrorOf;

/// The bytes of numbers one after the other.
template <typename... T>
std::string Bytes(T... numbers) {
  std::string bytes;
  (bytes.append(reinterpret_cast<const char*>(&numbers), sizeof(T)), ...);
  return bytes;
}

/// With CRLF instead of LF.
inline std::string WithWindowsLines(const std::string& text) {
  std::string windows;
  for (const char c : text) windows.append(c == '\n' ? "\r\n" : std::string(1, c));
  return windows;
}

/// Reads a text (or bytes) with one of the readers, as if it were a file of this name.
template <typename Read>
auto ReadText(std::string_view content, const Read& read, const std::string& name = "file") {
  std::istringstream in{std::string(content)};
  return read(in, name);
}

/// The sentence with which a reader refuses a text.
template <typename Read>
std::string ErrorOfText(std::string_view content, const Read& read) {
  return ErrorOf([&] { ReadText(content, read); });
}

/// What a writer makes of its arguments.
template <typename Write, typename... Args>
std::string Written(const Write& write, const Args&... args) {
  std::ostringstream out;
  write(out, args...);
  return out.str();
}

/// Three points whose coordinates are exact as floats and as centimetres.
inline PointCloud SmallCloud() {
  PointCloud cloud;
  cloud.positions = {{1.0, 2.0, 3.0}, {-0.5, 0.25, 8.0}, {100.0, -0.125, 0.0}};
  return cloud;
}

inline PointCloud SmallCloudWithAttributes() {
  PointCloud cloud = SmallCloud();
  cloud.reflectance = {0.5F, 17.0F, 255.0F};
  cloud.normals = {{1.0, 0.0, 0.0}, {0.0, -1.0, 0.0}, {0.0, 0.0, 1.0}};
  return cloud;
}

inline void ExpectEqual(const PointCloud& actual, const PointCloud& expected) {
  EXPECT_EQ(actual.positions, expected.positions);
  EXPECT_EQ(actual.reflectance, expected.reflectance);
  EXPECT_EQ(actual.normals, expected.normals);
  EXPECT_EQ(actual.slice_begin, expected.slice_begin);
}

/// The folder of real data (ARIADNE_DATA, else beside the sources); the caller skips where it is missing.
inline fs::path DataFolder() {
  const char* const given = std::getenv("ARIADNE_DATA");
  return given != nullptr ? fs::path(given) : fs::path(ARIADNE_SOURCE_DIR) / ".." / "shared" / "data";
}

}  // namespace ariadne::slam::testing_support

/// Skips the test where the real data are not there.
#define ARIADNE_REQUIRE_DATA(folder)                                                       \
  if (!std::filesystem::exists(folder)) {                                                  \
    GTEST_SKIP() << (folder) << " is missing; set ARIADNE_DATA to the folder with scans/"; \
  }
