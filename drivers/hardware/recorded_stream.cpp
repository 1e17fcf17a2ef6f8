#include "drivers/hardware/recorded_stream.h"

#include <algorithm>
#include <utility>

namespace ariadne::drivers {

RecordingStream::RecordingStream(std::unique_ptr<ByteStream> line,
                                 std::function<void(const LineRecord&)> record)
    : line_(std::move(line)), record_(std::move(record)), now_(line_->Now()) {
  const std::string name = line_->name();
  Record({LineRecord::Kind::kOpen, 0.0, Bytes(name.begin(), name.end()), line_->baud()});
}

void RecordingStream::Record(LineRecord record) {
  now_ = line_->Now();
  record.time = now_;
  record_(record);
}

Bytes RecordingStream::Read(double deadline) {
  Bytes bytes = line_->Read(deadline);
  Record({LineRecord::Kind::kRead, 0.0, bytes});
  return bytes;
}

void RecordingStream::Write(ByteView bytes) {
  line_->Write(bytes);
  Record({LineRecord::Kind::kWrite, 0.0, Bytes(bytes.begin(), bytes.end())});
}

void RecordingStream::SetBaud(int baud) {
  line_->SetBaud(baud);
  Record({LineRecord::Kind::kBaud, 0.0, {}, baud});
}

RecordedStream::RecordedStream(std::vector<LineRecord> records) : records_(std::move(records)) {
  const LineRecord& open = Take(LineRecord::Kind::kOpen);
  name_.assign(open.bytes.begin(), open.bytes.end());
  baud_ = open.baud;
}

const LineRecord& RecordedStream::Take(LineRecord::Kind kind) {
  if (next_ == records_.size()) Fail("the recording of {} ends after {} calls", name_, records_.size());
  const LineRecord& record = records_[next_];
  if (record.kind != kind) Fail("call {} to {} was another one when it was recorded", next_ + 1, name_);
  ++next_;
  now_ = record.time;
  return record;
}

Bytes RecordedStream::Read(double) { return Take(LineRecord::Kind::kRead).bytes; }

void RecordedStream::Write(ByteView bytes) {
  const LineRecord& record = Take(LineRecord::Kind::kWrite);
  if (!std::equal(bytes.begin(), bytes.end(), record.bytes.begin(), record.bytes.end())) {
    Fail("call {} to {} wrote other bytes when it was recorded", next_, name_);
  }
}

void RecordedStream::SetBaud(int baud) {
  const LineRecord& record = Take(LineRecord::Kind::kBaud);
  if (record.baud != baud) {
    Fail("call {} to {} set {} baud when it was recorded, not {}", next_, name_, record.baud, baud);
  }
  baud_ = baud;
}

}  // namespace ariadne::drivers
