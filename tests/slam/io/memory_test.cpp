// What reading costs in memory: the points of a file and little more, and nothing for counts that lie.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <fstream>

#include "slam/io/cloud_io.h"
#include "slam/io/file.h"
#include "slam/io/kitti.h"
#include "slam/io/pcd.h"
#include "slam/io/ply.h"
#include "slam/io/uos_cloud.h"
#include "slam/io/xyz.h"
#include "tests/slam/io/support.h"

namespace ariadne::slam {
namespace {

using namespace testing_support;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif

constexpr std::size_t kMegabyte = 1 << 20;

std::size_t AddressSpace() {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

/// Lets the program take so many bytes more and no others, while it lives.
class MemoryLimit {
 public:
  explicit MemoryLimit(std::size_t more_bytes) {
    getrlimit(RLIMIT_AS, &old_);
    const rlimit limited{AddressSpace() + more_bytes, old_.rlim_max};
    setrlimit(RLIMIT_AS, &limited);
  }
  ~MemoryLimit() { setrlimit(RLIMIT_AS, &old_); }
  MemoryLimit(const MemoryLimit&) = delete;
  MemoryLimit& operator=(const MemoryLimit&) = delete;

 private:
  rlimit old_{};
};

PointCloud ManyPoints(std::size_t count) {
  PointCloud cloud;
  for (std::size_t i = 0; i < count; ++i) {
    cloud.positions.emplace_back(1e-3 * static_cast<double>(i), 12.345, -1.0);
    cloud.reflectance.push_back(1.0F);
  }
  return cloud;
}

TEST(Memory, ReadingTakesThePointsAndLittleMore) {
  if (kSanitized) GTEST_SKIP() << "sanitizers take memory of their own";
  constexpr std::size_t kPoints = 200'000;
  constexpr std::size_t kBytes = kPoints * (sizeof(Eigen::Vector3d) + sizeof(float));  // 5.6 MB
  const TemporaryFolder folder;
  for (const char* name : {"a.3d", "a.xyz", "a.ply", "a.pcd", "a.bin"}) {
    WriteCloud(folder / name, ManyPoints(kPoints));
    const auto format = FormatFromPath(folder / name);
    const MemoryLimit limit(kBytes + 4 * kMegabyte);
    const auto read = [&](std::istream& in, const std::string& file) -> std::size_t {
      if (format == CloudFormat::kUos) return ReadUosCloud(in, file).size();
      if (format == CloudFormat::kXyz) return ReadXyz(in, file).size();
      if (format == CloudFormat::kPly) return ReadPly(in, file).size();
      if (format == CloudFormat::kPcd) return ReadPcd(in, file).cloud.size();
      return ReadKitti(in, file).size();
    };
    EXPECT_EQ(ReadFile(folder / name, read), kPoints) << name;
  }
}

TEST(Memory, CountsThatLieTakeNone) {
  if (kSanitized) GTEST_SKIP() << "sanitizers take memory of their own";
  const std::string pcd = "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nHEIGHT 1\n";
  const std::string ply = "property float x\nproperty float y\nproperty float z\nend_header\n1 2 3\n";
  const MemoryLimit limit(8 * kMegabyte);
  for (const char* data : {"ascii", "binary", "binary_compressed"}) {
    const std::string counts = "WIDTH 99999999999\nPOINTS 99999999999\nDATA " + std::string(data) + "\n";
    ErrorOfText(pcd + counts + "0 0 0\n0 0 0\n", ReadPcd);
  }
  for (const char* format : {"ascii", "binary_little_endian"}) {
    ErrorOfText("ply\nformat " + std::string(format) + " 1.0\nelement vertex 4000000000\n" + ply, ReadPly);
  }
}

}  // namespace
}  // namespace ariadne::slam
