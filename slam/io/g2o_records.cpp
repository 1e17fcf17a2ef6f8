#include "slam/io/g2o_records.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "slam/io/g2o_fields.h"

namespace ariadne::slam {
namespace {

enum class What { kVertex, kEdge, kPrior };

struct Kind {
  std::string_view tag;
  What what;
  bool in_space;
  bool toro;  // the elder format, in which angles and information are written otherwise
};

constexpr std::array<Kind, 10> kKinds{{{"EDGE_SE3:QUAT", What::kEdge, true, false},
                                       {"EDGE_SE2", What::kEdge, false, false},
                                       {"VERTEX_SE3:QUAT", What::kVertex, true, false},
                                       {"VERTEX_SE2", What::kVertex, false, false},
                                       {"EDGE_SE3_PRIOR", What::kPrior, true, false},
                                       {"EDGE_PRIOR_SE2", What::kPrior, false, false},
                                       {"EDGE3", What::kEdge, true, true},
                                       {"EDGE2", What::kEdge, false, true},
                                       {"VERTEX3", What::kVertex, true, true},
                                       {"VERTEX2", What::kVertex, false, true}}};

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
    const auto kind = std::ranges::find(kKinds, tag, &Kind::tag);
    if (kind != kKinds.end()) {
      RequireDimension(*kind);
      if (kind->in_space) {
        AddTo(records_.space, *kind, fields);
      } else {
        AddTo(records_.plane, *kind, fields);
      }
    } else if (tag == "FIX") {
      AddFixed(fields);
    } else if (tag == "PARAMS_SE3OFFSET") {
      const std::int64_t id = fields.NextId();
      records_.offsets.push_back({id, reader_.line(), G2oPose3(reader_, fields.Numbers(7))});
    } else if (std::ranges::find(kSkipped, tag) != kSkipped.end()) {
      ++records_.skipped;
    } else {
      FailAtUnknown(tag);
    }
  }

  template <typename Pose>
  void AddTo(G2oPoses<Pose>& poses, const Kind& kind, G2oFields& fields) {
    constexpr std::size_t kTriangle = Pose::kDof * (Pose::kDof + 1) / 2;
    const std::size_t pose_size = Pose::kDof + (kind.in_space && !kind.toro ? 1 : 0);
    const std::int64_t id = fields.NextId();
    const bool second = kind.what == What::kEdge || (kind.what == What::kPrior && kind.in_space);
    const std::int64_t second_id = second ? fields.NextId() : 0;
    const bool measured = kind.what != What::kVertex;
    const std::span<const double> n = fields.Numbers(pose_size + (measured ? kTriangle : 0));
    const Pose pose = PoseFrom(n, kind, Pose());
    if (!measured) {
      poses.vertices.push_back({id, reader_.line(), pose});
      return;
    }
    const auto information = InformationFrom(n.subspan(pose_size), kind, Pose());
    if (kind.what == What::kEdge) {
      poses.edges.push_back({id, second_id, reader_.line(), pose, information});
    } else {
      poses.priors.push_back({id, reader_.line(), second_id, pose, information});
    }
  }

  Pose2 PoseFrom(std::span<const double> n, const Kind&, const Pose2&) const { return G2oPose2(n); }
  Pose3 PoseFrom(std::span<const double> n, const Kind& kind, const Pose3&) const {
    return kind.toro ? ToroPose3(n) : G2oPose3(reader_, n);
  }
  Pose2::Square InformationFrom(std::span<const double> n, const Kind& kind, const Pose2&) const {
    return kind.toro ? ToroInformation2(reader_, n) : G2oInformation2(reader_, n);
  }
  Pose3::Square InformationFrom(std::span<const double> n, const Kind& kind, const Pose3&) const {
    return kind.toro ? ToroInformation3(reader_, n) : G2oInformation3(reader_, n);
  }

  void AddFixed(G2oFields& fields) {
    do {
      records_.fixed.push_back({fields.NextId(), reader_.line()});
    } while (!fields.AtEnd());
  }

  /// All poses are of the kind of the first.
  void RequireDimension(const Kind& kind) {
    if (first_pose_line_ == 0) {
      first_pose_line_ = reader_.line();
      records_.in_space = kind.in_space;
    }
    if (records_.in_space == kind.in_space) return;
    const auto where = [](bool in_space) { return in_space ? "space" : "the plane"; };
    reader_.FailAtLine("{} is a record of poses in {}, but line {} is of poses in {}; a graph has one kind",
                       kind.tag, where(kind.in_space), first_pose_line_, where(records_.in_space));
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
