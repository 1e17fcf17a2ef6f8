#include "drivers/hardware/recorded_lines.h"

#include <fmt/format.h>

#include <utility>

#include "drivers/hardware/line_log.h"

namespace ariadne::drivers {
namespace {

bool IsTheSame(const LineRecord& asked, const LineRecord& recorded) {
  if (recorded.kind == LineRecord::Kind::kError) return true;  // of whatever was asked
  if (asked.kind != recorded.kind) return false;
  if (asked.kind == LineRecord::Kind::kWrite) return asked.bytes == recorded.bytes;
  return asked.kind != LineRecord::Kind::kBaud || asked.baud == recorded.baud;
}

}  // namespace

/// One of the lines, with a clock of its own: that of its last call.
class RecordedLines::Line : public ByteStream {
 public:
  Line(RecordedLines& lines, std::uint8_t number) : lines_(lines), number_(number) {
    const LineRecord open = Repeat({LineRecord::Kind::kOpen, 0.0, {}});
    name_ = TextOf(open);
    baud_ = open.baud;
    lines_.names_[number_] = name_;
  }

  std::string name() const override { return name_; }
  double Now() const override { return now_; }
  int baud() const override { return baud_; }
  Bytes Read(double) override { return Repeat({LineRecord::Kind::kRead, 0.0, {}}).bytes; }
  void Write(ByteView bytes) override {
    Repeat({LineRecord::Kind::kWrite, 0.0, Bytes(bytes.begin(), bytes.end())});
  }
  void SetBaud(int baud) override {
    Repeat({LineRecord::Kind::kBaud, 0.0, {}, baud});
    baud_ = baud;
  }

 private:
  LineRecord Repeat(const LineRecord& asked) {
    LineRecord recorded = lines_.Repeat(number_, asked);
    now_ = recorded.time;
    if (recorded.kind == LineRecord::Kind::kError) throw Error(TextOf(recorded));
    return recorded;
  }

  RecordedLines& lines_;
  std::uint8_t number_;
  std::string name_;
  double now_ = 0.0;
  int baud_ = 9600;
};

RecordedLines::RecordedLines(std::string name, std::function<std::optional<LoggedRecord>()> next)
    : name_(std::move(name)), next_(std::move(next)) {}

RecordedLines::RecordedLines(const std::filesystem::path& log)
    : RecordedLines(log.string(),
                    [reader = std::make_shared<LineLogReader>(log)] { return reader->Next(); }) {}

std::unique_ptr<ByteStream> RecordedLines::Open(std::uint8_t line) {
  return std::make_unique<Line>(*this, line);
}

std::optional<LoggedRecord> RecordedLines::NextCall() {
  for (;;) {
    std::optional<LoggedRecord> next = next_();
    if (!next || next->record.kind != LineRecord::Kind::kNote) return next;
  }
}

std::string RecordedLines::NameOf(std::uint8_t line) const {
  const auto known = names_.find(line);
  return known == names_.end() ? fmt::format("line {}", line) : known->second;
}

void RecordedLines::Depart(const LoggedRecord& recorded, const std::string& instead) {
  departure_ = fmt::format("{}: call {} to the lines ({:.3f} s) was recorded as {} being {}; now {}", name_,
                           repeated_ + 1, recorded.record.time, NameOf(recorded.line),
                           Describe(recorded.record), instead);
}

LineRecord RecordedLines::Repeat(std::uint8_t line, const LineRecord& asked) {
  if (!departure_.empty()) throw Error(departure_);
  std::optional<LoggedRecord> recorded = NextCall();
  if (!recorded)
    throw LinesEnded(fmt::format("{}: the recording ends after {} calls to the lines", name_, repeated_));
  if (recorded->line != line || !IsTheSame(asked, recorded->record)) {
    Depart(*recorded, fmt::format("{} is {}", NameOf(line), Describe(asked)));
    throw Error(departure_);
  }
  ++repeated_;
  time_ = recorded->record.time;
  return std::move(recorded->record);
}

void RecordedLines::ExpectEnd() {
  if (!departure_.empty()) return;
  if (const std::optional<LoggedRecord> next = NextCall()) Depart(*next, "no line is used any more");
}

RecordedLines OneRecordedLine(std::vector<LineRecord> records) {
  return {"the recording of a line", [records = std::move(records), next = std::size_t{0}]() mutable {
            std::optional<LoggedRecord> logged;
            if (next < records.size()) logged = LoggedRecord{0, records[next++]};
            return logged;
          }};
}

}  // namespace ariadne::drivers
