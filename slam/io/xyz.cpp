#include "slam/io/xyz.h"

#include "slam/io/chunked_output.h"
#include "slam/io/text_points.h"
#include "slam/io/writable.h"

namespace ariadne::slam {

PointCloud ReadXyz(std::istream& in, const std::string& name) {
  const auto line_ends = CountLineEnds(in);
  StreamReader reader(in, name);
  return ReadTextPoints(reader, {.delimiters = ",;", .comments = true}, line_ends);
}

void WriteXyz(std::ostream& out, const PointCloud& cloud) {
  CheckWritableWithPoints(cloud);
  ChunkedOutput output(out);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3d& p = cloud.positions[i];
    output.Print("{} {} {}", p.x(), p.y(), p.z());
    if (!cloud.reflectance.empty()) output.Print(" {}", cloud.reflectance[i]);
    output.Print("\n");
  }
  output.Flush();
}

}  // namespace ariadne::slam
