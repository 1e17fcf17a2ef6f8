#include "slam/io/carmen.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "slam/base/error.h"
#include "slam/geometry/angles.h"
#include "slam/io/bzip2.h"
#include "slam/io/chunked_output.h"
#include "slam/io/row_parser.h"

namespace ariadne::slam {
namespace {

constexpr std::size_t kMinBeams = 2;
constexpr double kWrittenNoReturn = 81.91;  // as the SICK LMS says "none" [m]

/// 180 and 360 beams leave out the last direction, 181 and 361 have it.
double AngleStep(std::size_t beams) {
  return std::numbers::pi / static_cast<double>(beams % 2 == 0 ? beams : beams - 1);
}

/// The words of an FLASER record, one after the other.
class Words {
 public:
  Words(const StreamReader& reader, std::vector<std::string_view> words)
      : reader_(reader), words_(std::move(words)) {}

  std::size_t left() const { return words_.size() - next_; }
  std::string_view Next() { return words_[next_++]; }

  double Number() {
    const std::string_view word = Next();
    const std::optional<double> number = ParseNumber(word);
    if (!number || !std::isfinite(*number)) reader_.FailAtLine("{} is not a finite number", Quoted(word));
    return *number;
  }

  float Range() {
    const double range = Number();
    if (range < 0.0) reader_.FailAtLine("the range {} is below zero", range);
    return range < CarmenReader::kNoReturn ? static_cast<float>(range) : LaserSweep::kNoReturn;
  }

  Pose2 Pose() {
    const double x = Number();
    const double y = Number();
    return {WrapAngle(Number()), {x, y}};
  }

 private:
  const StreamReader& reader_;
  std::vector<std::string_view> words_;
  std::size_t next_ = 0;
};

/// Takes the count of beams; Error unless the record has room for them and for what follows.
std::size_t BeamCount(const StreamReader& reader, Words& words) {
  constexpr std::size_t kAfter = 9;  // two poses, stamp, host, stamp
  const std::string_view word = words.left() > 0 ? words.Next() : "";
  const std::optional<std::uint64_t> beams = ParseCount(word);
  if (!beams || *beams < kMinBeams) {
    reader.FailAtLine(
        "an FLASER record begins with the number of its ranges, at least {}, but here with {}", kMinBeams,
        Quoted(word));
  }
  if (words.left() < kAfter || words.left() - kAfter != *beams) {
    reader.FailAtLine("{} ranges and {} more words are expected, but the line has {} words; {}", *beams,
                      kAfter, words.left(), "it is damaged: remove it");
  }
  return *beams;
}

void CheckWritable(const CarmenSweep& sweep) {
  const std::size_t beams = sweep.sweep.ranges.size();
  const ScannerModel& scanner = sweep.scanner;
  if (beams < kMinBeams || scanner.first_angle != 0.0 || scanner.angle_step != AngleStep(beams)) {
    Fail(
        "only sweeps over 180 deg can be written as FLASER, not {} beams in steps of {:.6g} deg from "
        "{:.6g}",
        beams, DegFromRad(scanner.angle_step), DegFromRad(scanner.first_angle));
  }
  const auto finite = [](const Pose2& pose) {
    return std::isfinite(pose.angle) && pose.translation.allFinite();
  };
  if (!finite(sweep.T_odom_laser) || !finite(sweep.T_odom_base) || !std::isfinite(sweep.sweep.stamp)) {
    Fail("cannot write a sweep whose pose or stamp is NaN or infinite");
  }
  for (const float range : sweep.sweep.ranges) {
    if (range < 0.0F || range >= static_cast<float>(CarmenReader::kNoReturn)) {
      Fail("cannot write the range {} m; expected 0 to {}", range, CarmenReader::kNoReturn);
    }
  }
}

void PrintPose(ChunkedOutput& output, const Pose2& pose) {
  output.Print(" {} {} {}", pose.translation.x(), pose.translation.y(), pose.angle);
}

}  // namespace

CarmenReader::CarmenReader(std::istream& in, const std::string& name)
    : decompressed_(IsBzip2(in) ? DecompressBzip2(in, name) : nullptr),
      reader_(decompressed_ ? *decompressed_ : in, name) {}

std::optional<CarmenSweep> CarmenReader::Next() {
  constexpr std::string_view kTag = "FLASER";
  while (const std::optional<std::string_view> line = reader_.NextLine()) {
    if (line->substr(0, line->find_first_of(" \t")) != kTag) continue;
    found_ = true;
    return Parse(line->substr(kTag.size()));
  }
  if (!found_) Fail("{}: holds no FLASER records; it is not a log of CARMEN's front laser", reader_.name());
  return std::nullopt;
}

CarmenSweep CarmenReader::Parse(std::string_view line) const {
  Words words(reader_, SplitAtBlanks(line));
  CarmenSweep result;
  result.line = reader_.line();
  const std::size_t beams = BeamCount(reader_, words);
  result.scanner.angle_step = AngleStep(beams);
  result.sweep.ranges.reserve(beams);
  for (std::size_t i = 0; i < beams; ++i) result.sweep.ranges.push_back(words.Range());
  result.T_odom_laser = words.Pose();
  result.T_odom_base = words.Pose();
  result.sweep.stamp = words.Number();
  return result;
}

std::vector<CarmenSweep> ReadCarmen(std::istream& in, const std::string& name) {
  CarmenReader reader(in, name);
  std::vector<CarmenSweep> sweeps;
  while (std::optional<CarmenSweep> sweep = reader.Next()) sweeps.push_back(*std::move(sweep));
  return sweeps;
}

void WriteCarmen(std::ostream& out, std::span<const CarmenSweep> sweeps) {
  ChunkedOutput output(out);
  for (const CarmenSweep& sweep : sweeps) {
    CheckWritable(sweep);
    output.Print("FLASER {}", sweep.sweep.ranges.size());
    for (const float range : sweep.sweep.ranges) {
      if (std::isnan(range)) {
        output.Print(" {}", kWrittenNoReturn);
      } else {
        output.Print(" {}", range);
      }
    }
    PrintPose(output, sweep.T_odom_laser);
    PrintPose(output, sweep.T_odom_base);
    output.Print(" {} host {}\n", sweep.sweep.stamp, sweep.sweep.stamp);
  }
  output.Flush();
}

}  // namespace ariadne::slam
