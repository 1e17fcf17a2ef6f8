#include "drivers/hardware/recorded_stream.h"

#include <algorithm>
#include <utility>

namespace ariadne::drivers {

RecordingStream::RecordingStream(std::unique_ptr<ByteStream> line,
                                 std::function<void(const LineRecord&)> record)
    : line_(std::move(line)), record_(std::move(record)), now_(line_->Now()) {}

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

RecordedStream::RecordedStream(std::string name, double start, std::vector<LineRecord> records)
    : name_(std::move(name)), records_(std::move(records)), now_(start) {}

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
