#include "drivers/hardware/recorded_stream.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace ariadne::drivers {
namespace {

Bytes BytesOf(std::string_view text) { return {text.begin(), text.end()}; }

std::string WrittenText(const Bytes& bytes) {
  constexpr std::size_t kShown = 24;
  const ByteView shown = ByteView(bytes).first(std::min(bytes.size(), kShown));
  const bool all = shown.size() == bytes.size();
  return fmt::format("written {:02X}{}", fmt::join(shown, " "),
                     all ? "" : fmt::format(" ... ({} bytes)", bytes.size()));
}

}  // namespace

std::string Describe(const LineRecord& record) {
  switch (record.kind) {
    case LineRecord::Kind::kOpen:
      return "opened";
    case LineRecord::Kind::kRead:
      return "read";
    case LineRecord::Kind::kWrite:
      return WrittenText(record.bytes);
    case LineRecord::Kind::kBaud:
      return fmt::format("set to {} baud", record.baud);
    case LineRecord::Kind::kError:
      return fmt::format("failing: {}", TextOf(record));
    case LineRecord::Kind::kNote:
      break;
  }
  return fmt::format("noted: {}", TextOf(record));
}

RecordingStream::RecordingStream(std::unique_ptr<ByteStream> line,
                                 std::function<void(const LineRecord&)> record)
    : line_(std::move(line)), record_(std::move(record)), now_(line_->Now()) {
  Record({LineRecord::Kind::kOpen, 0.0, BytesOf(line_->name()), line_->baud()});
}

void RecordingStream::Record(LineRecord record) {
  now_ = line_->Now();
  record.time = now_;
  record_(record);
}

/// What the line throws is on the record too: somebody may go on after it.
template <typename Call>
void RecordingStream::Recorded(LineRecord record, const Call& call) {
  try {
    call(record);
  } catch (const Error& error) {
    Record({LineRecord::Kind::kError, 0.0, BytesOf(error.what())});
    throw;
  }
  Record(std::move(record));
}

Bytes RecordingStream::Read(double deadline) {
  Bytes bytes;
  Recorded({LineRecord::Kind::kRead, 0.0, {}}, [&](LineRecord& record) {
    bytes = line_->Read(deadline);
    record.bytes = bytes;
  });
  return bytes;
}

void RecordingStream::Write(ByteView bytes) {
  Recorded({LineRecord::Kind::kWrite, 0.0, Bytes(bytes.begin(), bytes.end())},
           [&](const LineRecord&) { line_->Write(bytes); });
}

void RecordingStream::SetBaud(int baud) {
  Recorded({LineRecord::Kind::kBaud, 0.0, {}, baud}, [&](const LineRecord&) { line_->SetBaud(baud); });
}

}  // namespace ariadne::drivers
