// How fast clouds are read from the page cache, in bytes of the file per second and core. The yardsticks
// are what a program does without thought (`ifstream >> double`), and the copy out of the page cache
// without looking at the bytes, which no reader can beat.
#include <benchmark/benchmark.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "slam/base/random.h"
#include "slam/io/cloud_io.h"
#include "slam/io/file.h"
#include "slam/io/kitti.h"
#include "slam/io/pcd.h"
#include "slam/io/ply.h"
#include "slam/io/uos_cloud.h"
#include "slam/io/xyz.h"

namespace ariadne::slam {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kTextPoints = 1'000'000;
constexpr std::size_t kBinaryPoints = 5'000'000;

/// Points in a hall of 40 x 40 x 6 m, to the millimetre, as scanners give them.
PointCloud HallOfPoints(std::size_t count) {
  RandomStream stream = NamedStream(1, "io_bench");
  const auto draw = [&](double half) {
    return std::round(1000.0 * DrawUniform(stream, -half, half)) / 1000.0;
  };
  PointCloud cloud;
  for (std::size_t i = 0; i < count; ++i) {
    cloud.positions.emplace_back(draw(20.0), draw(20.0), draw(3.0));
    cloud.reflectance.push_back(static_cast<float>(std::floor(DrawUniform(stream, 0.0, 256.0))));
  }
  return cloud;
}

/// A file that lives as long as the benchmark that reads it.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::function<void(std::ostream&)>& write)
      : path_(fs::temp_directory_path() / ("ariadne_io_bench." + std::to_string(getpid()))) {
    WriteFileAtomically(path_, write);
  }
  ~TemporaryFile() { fs::remove(path_); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

template <typename Write, typename Read>
void Measure(benchmark::State& state, std::size_t points, const Write& write, const Read& read) {
  const PointCloud cloud = HallOfPoints(points);
  const TemporaryFile file([&](std::ostream& out) { write(out, cloud); });
  for (auto _ : state) {
    const auto result = ReadFile(file.path(), read);
    benchmark::DoNotOptimize(&result);
  }
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(fs::file_size(file.path())));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points));
}

/// As short as it can be written, and as slow.
PointCloud ReadByExtraction(std::istream& in, const std::string&) {
  PointCloud cloud;
  double x = 0.0, y = 0.0, z = 0.0;
  float reflectance = 0.0F;
  while (in >> x >> y >> z >> reflectance) {
    cloud.positions.emplace_back(x, y, z);
    cloud.reflectance.push_back(reflectance);
  }
  return cloud;
}

std::size_t CopyOut(std::istream& in, const std::string&) {
  std::vector<char> chunk(1 << 18);
  std::size_t bytes = 0;
  while (in.read(chunk.data(), static_cast<std::streamsize>(chunk.size()))) bytes += chunk.size();
  return bytes;
}

const auto kWriteUos = [](std::ostream& out, const PointCloud& cloud) { WriteUosCloud(out, cloud); };
const auto kWriteKitti = [](std::ostream& out, const PointCloud& cloud) { WriteKitti(out, cloud); };

template <PcdEncoding kEncoding>
void WritePcdAs(std::ostream& out, const PointCloud& cloud) {
  WritePcd(out, cloud, kEncoding);
}

template <PlyEncoding kEncoding>
void WritePlyAs(std::ostream& out, const PointCloud& cloud) {
  WritePly(out, cloud, kEncoding);
}

void Text_Extraction(benchmark::State& state) { Measure(state, kTextPoints, kWriteUos, ReadByExtraction); }
void Text_Uos(benchmark::State& state) { Measure(state, kTextPoints, kWriteUos, ReadUosCloud); }
void Text_Xyz(benchmark::State& state) { Measure(state, kTextPoints, WriteXyz, ReadXyz); }
void Text_Pcd(benchmark::State& state) {
  Measure(state, kTextPoints, WritePcdAs<PcdEncoding::kAscii>, ReadPcd);
}
void Text_Ply(benchmark::State& state) {
  Measure(state, kTextPoints, WritePlyAs<PlyEncoding::kAscii>, ReadPly);
}
void Binary_CopyOut(benchmark::State& state) { Measure(state, kBinaryPoints, kWriteKitti, CopyOut); }
void Binary_Kitti(benchmark::State& state) { Measure(state, kBinaryPoints, kWriteKitti, ReadKitti); }
void Binary_Ply(benchmark::State& state) {
  Measure(state, kBinaryPoints, WritePlyAs<PlyEncoding::kBinary>, ReadPly);
}
void Binary_Pcd(benchmark::State& state) {
  Measure(state, kBinaryPoints, WritePcdAs<PcdEncoding::kBinary>, ReadPcd);
}
void Binary_PcdCompressed(benchmark::State& state) {
  Measure(state, kBinaryPoints, WritePcdAs<PcdEncoding::kBinaryCompressed>, ReadPcd);
}

BENCHMARK(Text_Extraction)->Unit(benchmark::kMillisecond);
BENCHMARK(Text_Uos)->Unit(benchmark::kMillisecond);
BENCHMARK(Text_Xyz)->Unit(benchmark::kMillisecond);
BENCHMARK(Text_Pcd)->Unit(benchmark::kMillisecond);
BENCHMARK(Text_Ply)->Unit(benchmark::kMillisecond);
BENCHMARK(Binary_CopyOut)->Unit(benchmark::kMillisecond);
BENCHMARK(Binary_Kitti)->Unit(benchmark::kMillisecond);
BENCHMARK(Binary_Ply)->Unit(benchmark::kMillisecond);
BENCHMARK(Binary_Pcd)->Unit(benchmark::kMillisecond);
BENCHMARK(Binary_PcdCompressed)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace ariadne::slam
