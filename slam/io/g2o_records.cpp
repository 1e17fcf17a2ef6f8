#include "slam/io/g2o_records.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "slam/io/g2o_fields.h"

namespace ariadne::slam {
namespace {

/// Numbers of a pose and of the upper triangle of its information.
constexpr std::size_t kPose2 = 3, kInformation2 = 6, kPose3 = 7, kToroPose3 = 6, kInformation3 = 21;

/// Records that describe what no pose depends on.
constexpr std::array<std::string_view, 10> kSkipped{"VERTEX_TAG",
                                                    "ROBOTLASER1",
                                                    "RAWLASER1",
                                                    "FLASER",
                                                    "EQUIV",
                                                    "PARAMS_SE2OFFSET",
                                                    "PARAMS_CAMERACALIB",
                                                    "LASER_SENSOR_PARAMS",
                                                    "PARAMS_STEREOCAMERACALIB",
                                                    "ODOM"};

/// Words in the names of records of landmarks and cameras.
constexpr std::array<std::string_view, 9> kLandmarks{"XY",       "XYZ",     "POINT", "TRACK", "BEARING",
                                                     "LANDMARK", "PROJECT", "LINE",  "SIM3"};

class RecordReader {
 public:
  RecordReader(std::istream& in, const std::string& name) : reader_(in, name), parser_(reader_) {}

  G2oRecords Read() {
    while (const std::optional<std::string_view> line = reader_.NextLine()) {
      G2oFields fields(reader_, parser_, *line);
      if (!fields.tag().empty() && !fields.tag().starts_with('#')) Add(fields);
    }
    return std::move(records_);
  }

 private:
  void Add(G2oFields& fields) {
    const std::string_view tag = fields.tag();
    if (AddPlanar(fields) || AddSpatial(fields)) return;
    if (tag == "FIX") {
      AddFixed(fields);
    } else if (tag == "PARAMS_SE3OFFSET") {
      const std::int64_t id = fields.NextId();
      records_.offsets.push_back({id, reader_.line(), G2oPose3(reader_, fields.Numbers(kPose3))});
    } else if (std::ranges::find(kSkipped, tag) != kSkipped.end()) {
      ++records_.skipped;
    } else {
      FailAtUnknown(tag);
    }
  }

  bool AddPlanar(G2oFields& fields) {
    const std::string_view tag = fields.tag();
    G2oPoses<Pose2>& poses = records_.plane;
    if (tag == "EDGE_SE2" || tag == "EDGE2") {
      SetDimension(false, tag);
      const std::int64_t from = fields.NextId(), to = fields.NextId();
      const std::span<const double> n = fields.Numbers(kPose2 + kInformation2);
      const std::span<const double> information = n.subspan(kPose2);
      poses.edges.push_back({from, to, reader_.line(), G2oPose2(n),
                             tag == "EDGE2" ? ToroInformation2(reader_, information)
                                            : G2oInformation2(reader_, information)});
    } else if (tag == "VERTEX_SE2" || tag == "VERTEX2") {
      SetDimension(false, tag);
      const std::int64_t id = fields.NextId();
      poses.vertices.push_back({id, reader_.line(), G2oPose2(fields.Numbers(kPose2))});
    } else if (tag == "EDGE_PRIOR_SE2") {
      SetDimension(false, tag);
      const std::int64_t id = fields.NextId();
      const std::span<const double> n = fields.Numbers(kPose2 + kInformation2);
      poses.priors.push_back(
          {id, reader_.line(), 0, G2oPose2(n), G2oInformation2(reader_, n.subspan(kPose2))});
    } else {
      return false;
    }
    return true;
  }

  bool AddSpatial(G2oFields& fields) {
    const std::string_view tag = fields.tag();
    G2oPoses<Pose3>& poses = records_.space;
    if (tag == "EDGE_SE3:QUAT" || tag == "EDGE3") {
      SetDimension(true, tag);
      const std::int64_t from = fields.NextId(), to = fields.NextId();
      const bool toro = tag == "EDGE3";
      const std::size_t pose_size = toro ? kToroPose3 : kPose3;
      const std::span<const double> n = fields.Numbers(pose_size + kInformation3);
      const std::span<const double> information = n.subspan(pose_size);
      poses.edges.push_back(
          {from, to, reader_.line(), toro ? ToroPose3(n) : G2oPose3(reader_, n),
           toro ? ToroInformation3(reader_, information) : G2oInformation3(reader_, information)});
    } else if (tag == "VERTEX_SE3:QUAT") {
      SetDimension(true, tag);
      const std::int64_t id = fields.NextId();
      poses.vertices.push_back({id, reader_.line(), G2oPose3(reader_, fields.Numbers(kPose3))});
    } else if (tag == "VERTEX3") {
      SetDimension(true, tag);
      const std::int64_t id = fields.NextId();
      poses.vertices.push_back({id, reader_.line(), ToroPose3(fields.Numbers(kToroPose3))});
    } else if (tag == "EDGE_SE3_PRIOR") {
      SetDimension(true, tag);
      const std::int64_t id = fields.NextId(), offset = fields.NextId();
      const std::span<const double> n = fields.Numbers(kPose3 + kInformation3);
      poses.priors.push_back(
          {id, reader_.line(), offset, G2oPose3(reader_, n), G2oInformation3(reader_, n.subspan(kPose3))});
    } else {
      return false;
    }
    return true;
  }

  void AddFixed(G2oFields& fields) {
    do {
      records_.fixed.push_back({fields.NextId(), reader_.line()});
    } while (!fields.AtEnd());
  }

  void SetDimension(bool in_space, std::string_view tag) {
    if (first_pose_line_ == 0) first_pose_line_ = reader_.line();
    if (first_pose_line_ == reader_.line()) records_.in_space = in_space;
    if (records_.in_space == in_space) return;
    reader_.FailAtLine("{} is a record of poses in {}, but line {} is of poses in {}; a graph has one kind",
                       tag, in_space ? "space" : "the plane", first_pose_line_,
                       in_space ? "the plane" : "space");
  }

  [[noreturn]] void FailAtUnknown(std::string_view tag) const {
    for (const std::string_view word : kLandmarks) {
      if (tag.find(word) == std::string_view::npos) continue;
      reader_.FailAtLine("{} is a record of landmarks, which are not supported; remove them from the graph",
                         Quoted(tag));
    }
    reader_.FailAtLine(
        "{} is not a record of pose graphs; known are VERTEX_SE2, EDGE_SE2, EDGE_PRIOR_SE2, {}",
        Quoted(tag), "VERTEX_SE3:QUAT, EDGE_SE3:QUAT, EDGE_SE3_PRIOR, PARAMS_SE3OFFSET, FIX and TORO's");
  }

  StreamReader reader_;
  RowParser parser_;
  G2oRecords records_;
  std::size_t first_pose_line_ = 0;
};

}  // namespace

G2oRecords ReadG2oRecords(std::istream& in, const std::string& name) {
  return RecordReader(in, name).Read();
}

}  // namespace ariadne::slam
