#include <istream>
#include <ostream>
#include <string>

#include "slam/io/carmen.h"
#include "slam/io/kitti.h"
#include "slam/io/pcd.h"
#include "slam/io/ply.h"
#include "slam/io/uos_cloud.h"
#include "slam/io/xyz.h"
#include "slam/scan/slices.h"
#include "tests/fuzz/accepts.h"
#include "tests/fuzz/read_by.h"

namespace ariadne::fuzz {
namespace {

slam::PointCloud ReadPcdCloud(std::istream& in, const std::string& name) {
  return slam::ReadPcd(in, name).cloud;
}

template <slam::PlyEncoding kEncoding>
void WritePlyAs(std::ostream& out, const slam::PointCloud& cloud) {
  slam::WritePly(out, cloud, kEncoding);
}

template <slam::PcdEncoding kEncoding>
void WritePcdAs(std::ostream& out, const slam::PointCloud& cloud) {
  slam::WritePcd(out, cloud, kEncoding);
}

}  // namespace

bool AcceptsUosCloud(std::string_view bytes) {
  // What ReadCloud does with clouds that have no slices must survive any points as well.
  const auto read = [](std::istream& in, const std::string& name) {
    slam::PointCloud cloud = slam::ReadUosCloud(in, name);
    slam::InferSlices(cloud.positions);
    return cloud;
  };
  return Accepts(bytes, read, slam::WriteUosCloud);
}

bool AcceptsXyz(std::string_view bytes) { return Accepts(bytes, slam::ReadXyz, slam::WriteXyz); }

bool AcceptsPly(std::string_view bytes) {
  return Accepts(bytes, slam::ReadPly, WritePlyAs<slam::PlyEncoding::kAscii>) &&
         Accepts(bytes, slam::ReadPly, WritePlyAs<slam::PlyEncoding::kBinary>);
}

bool AcceptsPcd(std::string_view bytes) {
  return Accepts(bytes, ReadPcdCloud, WritePcdAs<slam::PcdEncoding::kAscii>) &&
         Accepts(bytes, ReadPcdCloud, WritePcdAs<slam::PcdEncoding::kBinary>) &&
         Accepts(bytes, ReadPcdCloud, WritePcdAs<slam::PcdEncoding::kBinaryCompressed>);
}

bool AcceptsKitti(std::string_view bytes) { return Accepts(bytes, slam::ReadKitti, slam::WriteKitti); }

bool AcceptsCarmen(std::string_view bytes) { return Accepts(bytes, slam::ReadCarmen, slam::WriteCarmen); }

}  // namespace ariadne::fuzz
