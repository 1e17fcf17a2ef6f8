#include "slam/io/kitti.h"

#include "slam/io/chunked_output.h"
#include "slam/io/records.h"
#include "slam/io/writable.h"

namespace ariadne::slam {
namespace {

RecordLayout Layout() {
  RecordLayout layout;
  for (int field = 0; field < 4; ++field) layout.Append(ScalarType::kFloat32);
  return layout;
}

PointFields Fields() {
  PointFields fields;
  fields.reflectance = 3;
  return fields;
}

}  // namespace

PointCloud ReadKitti(std::istream& in, const std::string& name) {
  StreamReader reader(in, name);
  const RecordLayout layout = Layout();
  PointGatherer points(Fields(), PointGatherer::NanPolicy::kDefect);
  points.Reserve(static_cast<std::size_t>(reader.Remaining().value_or(0) / layout.stride));
  GatherRecords(reader, layout, std::nullopt, points);
  if (points.cloud().empty()) Fail("{}: is empty; expected records of 16 bytes", name);
  return points.TakeCloud();
}

void WriteKitti(std::ostream& out, const PointCloud& cloud_laser) {
  CheckWritableWithPoints(cloud_laser);
  ChunkedOutput output(out);
  for (std::size_t i = 0; i < cloud_laser.size(); ++i) {
    for (const double coordinate : cloud_laser.positions[i]) output.PutBytes(FloatCoordinate(coordinate));
    output.PutBytes(cloud_laser.reflectance.empty() ? 0.0F : cloud_laser.reflectance[i]);
  }
  output.Flush();
}

}  // namespace ariadne::slam
