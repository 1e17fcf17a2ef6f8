#include "slam/base/error.h"
#include "slam/io/chunked_output.h"
#include "slam/io/lzf.h"
#include "slam/io/pcd.h"
#include "slam/io/writable.h"

namespace ariadne::slam {
namespace {

std::string Repeated(std::string_view word, std::size_t count) {
  std::string line;
  for (std::size_t i = 0; i < count; ++i) line.append(" ").append(word);
  return line;
}

std::size_t CountFields(const PointCloud& cloud) {
  return 3 + (cloud.reflectance.empty() ? 0 : 1) + (cloud.normals.empty() ? 0 : 3);
}

std::string Header(const PointCloud& cloud, PcdEncoding encoding) {
  const std::size_t columns = GridColumns(cloud).value_or(cloud.size());
  const std::size_t rows = columns == 0 ? 1 : cloud.size() / columns;
  std::string header = "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z";
  if (!cloud.reflectance.empty()) header += " intensity";
  if (!cloud.normals.empty()) header += " normal_x normal_y normal_z";
  const std::size_t fields = CountFields(cloud);
  header += "\nSIZE" + Repeated("4", fields) + "\nTYPE" + Repeated("F", fields) + "\nCOUNT" +
            Repeated("1", fields);
  header += fmt::format("\nWIDTH {}\nHEIGHT {}\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS {}\nDATA ", columns, rows,
                        cloud.size());
  switch (encoding) {
    case PcdEncoding::kAscii:
      return header + "ascii\n";
    case PcdEncoding::kBinary:
      return header + "binary\n";
    case PcdEncoding::kBinaryCompressed:
      break;
  }
  return header + "binary_compressed\n";
}

/// A field of a point, numbered as in the header.
float Field(const PointCloud& cloud, std::size_t point, std::size_t field) {
  const auto axis = static_cast<Eigen::Index>(field);
  if (field < 3) return FloatCoordinate(cloud.positions[point][axis]);
  if (!cloud.reflectance.empty() && field == 3) return cloud.reflectance[point];
  const Eigen::Index first_normal = cloud.reflectance.empty() ? 3 : 4;
  return FloatCoordinate(cloud.normals[point][axis - first_normal]);
}

void WriteAscii(std::ostream& out, const PointCloud& cloud) {
  ChunkedOutput output(out);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    for (std::size_t f = 0; f < CountFields(cloud); ++f) {
      output.Print("{}{}", f == 0 ? "" : " ", Field(cloud, i, f));
    }
    output.Print("\n");
  }
  output.Flush();
}

void WriteBinary(std::ostream& out, const PointCloud& cloud) {
  ChunkedOutput output(out);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    for (std::size_t f = 0; f < CountFields(cloud); ++f) output.PutBytes(Field(cloud, i, f));
  }
  output.Flush();
}

/// Field after field, since equal neighbours compress best.
void WriteCompressed(std::ostream& out, const PointCloud& cloud) {
  const std::size_t numbers = cloud.size() * CountFields(cloud);
  if (numbers * sizeof(float) > kLargestLzfInput) {
    Fail("{} points are too many for binary_compressed; write them as binary", cloud.size());
  }
  std::vector<float> fields;
  fields.reserve(numbers);
  for (std::size_t f = 0; f < CountFields(cloud); ++f) {
    for (std::size_t i = 0; i < cloud.size(); ++i) fields.push_back(Field(cloud, i, f));
  }
  const std::string_view bytes(reinterpret_cast<const char*>(fields.data()), fields.size() * sizeof(float));
  const std::vector<char> compressed = LzfCompressed(bytes);
  ChunkedOutput output(out);
  output.PutBytes(static_cast<std::uint32_t>(compressed.size()));
  output.PutBytes(static_cast<std::uint32_t>(bytes.size()));
  output.Flush();
  out.write(compressed.data(), static_cast<std::streamsize>(compressed.size()));
}

}  // namespace

void WritePcd(std::ostream& out, const PointCloud& cloud, PcdEncoding encoding) {
  CheckWritable(cloud);
  out << Header(cloud, encoding);
  if (encoding == PcdEncoding::kAscii) WriteAscii(out, cloud);
  if (encoding == PcdEncoding::kBinary) WriteBinary(out, cloud);
  if (encoding == PcdEncoding::kBinaryCompressed) WriteCompressed(out, cloud);
}

}  // namespace ariadne::slam
