#include "slam/base/error.h"
#include "slam/io/chunked_output.h"
#include "slam/io/ply.h"
#include "slam/io/writable.h"

namespace ariadne::slam {
namespace {

std::string Header(PlyEncoding encoding, const PlyColumns& columns, std::size_t points) {
  std::string header = "ply\n";
  header += encoding == PlyEncoding::kAscii ? "format ascii 1.0\n" : "format binary_little_endian 1.0\n";
  header += "comment ariadne: metres, x forward, y left, z up\n";
  header += fmt::format("element vertex {}\n", points);
  header += "property float x\nproperty float y\nproperty float z\n";
  if (columns.normals) header += "property float nx\nproperty float ny\nproperty float nz\n";
  if (columns.colors) header += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  // CloudCompare takes what begins with "scalar_" as a scalar field without asking.
  if (columns.reflectance) header += "property float scalar_reflectance\n";
  if (columns.scan_index) header += "property int scalar_scan_index\n";
  return header + "end_header\n";
}

/// Puts the values of a point one after the other, as text or bytes.
class RecordOutput {
 public:
  RecordOutput(std::ostream& out, PlyEncoding encoding) : output_(out), encoding_(encoding) {}

  template <typename T>
  void Put(T value) {
    if (encoding_ == PlyEncoding::kBinary) {
      output_.PutBytes(value);
    } else {
      output_.Print("{}{}", first_ ? "" : " ", value);
    }
    first_ = false;
  }
  void Put(const Eigen::Vector3d& vector) {
    for (const double coordinate : vector) Put(FloatCoordinate(coordinate));
  }
  void EndRecord() {
    if (encoding_ == PlyEncoding::kAscii) output_.Print("\n");
    first_ = true;
  }
  void Flush() { output_.Flush(); }

 private:
  ChunkedOutput output_;
  PlyEncoding encoding_;
  bool first_ = true;
};

void CheckColumns(const PlyColumns& columns, const PointCloud& cloud, std::size_t colors) {
  if (cloud.empty()) return;
  const bool complete = (!columns.reflectance || !cloud.reflectance.empty()) &&
                        (!columns.normals || !cloud.normals.empty()) &&
                        (!columns.colors || colors == 1 || colors == cloud.size());
  if (!complete) Fail("a cloud lacks an attribute for which the PLY file has a column; write without it");
}

}  // namespace

PlyWriter::PlyWriter(std::ostream& out, PlyEncoding encoding, const PlyColumns& columns, std::size_t points)
    : out_(out), encoding_(encoding), columns_(columns), points_(points) {
  out_ << Header(encoding, columns, points);
}

void PlyWriter::Add(const PointCloud& cloud, const Labels& labels) {
  CheckWritable(cloud);
  CheckColumns(columns_, cloud, labels.colors.size());
  if (cloud.size() > points_ - written_) {
    Fail("more points than the {} that the PLY header announces", points_);
  }
  RecordOutput output(out_, encoding_);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    output.Put(cloud.positions[i]);
    if (columns_.normals) output.Put(cloud.normals[i]);
    if (columns_.colors) {
      for (const std::uint8_t share : labels.colors[labels.colors.size() == 1 ? 0 : i]) output.Put(share);
    }
    if (columns_.reflectance) output.Put(cloud.reflectance[i]);
    if (columns_.scan_index) output.Put(labels.scan_index);
    output.EndRecord();
  }
  output.Flush();
  written_ += cloud.size();
}

void PlyWriter::Finish() const {
  if (written_ != points_) Fail("{} points where the PLY header announces {}", written_, points_);
}

void WritePly(std::ostream& out, const PointCloud& cloud, PlyEncoding encoding) {
  const PlyColumns columns{.reflectance = !cloud.reflectance.empty(), .normals = !cloud.normals.empty()};
  PlyWriter writer(out, encoding, columns, cloud.size());
  writer.Add(cloud);
  writer.Finish();
}

}  // namespace ariadne::slam
