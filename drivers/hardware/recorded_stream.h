#pragma once

#include <functional>
#include <memory>

#include "drivers/hardware/byte_stream.h"
#include "slam/base/error.h"

namespace ariadne::drivers {

/// One call to a line, and when it returned; or a note between calls, which is of no line.
struct LineRecord {
  enum class Kind : std::uint8_t { kOpen, kRead, kWrite, kBaud, kError, kNote };

  Kind kind = Kind::kRead;
  double time = 0.0;  // [s], of the line
  Bytes bytes;        // read (perhaps none) or written; the name that was opened, the error, or the note
  int baud = 0;       // of kOpen and kBaud

  bool operator==(const LineRecord&) const = default;
};

/// What the bytes of a record say, of those that are text.
inline std::string TextOf(const LineRecord& record) { return {record.bytes.begin(), record.bytes.end()}; }

/// For a sentence: "read", "written 80 5A", "set to 9600 baud".
std::string Describe(const LineRecord& record);

/// A line whose calls are handed to `record` as they return or throw, after one that says that it was
/// opened. Its clock shows the time of the last one and goes on with the next, so that who talks over it
/// decides by nothing that is not recorded.
class RecordingStream : public ByteStream {
 public:
  RecordingStream(std::unique_ptr<ByteStream> line, std::function<void(const LineRecord&)> record);

  std::string name() const override { return line_->name(); }
  double Now() const override { return now_; }
  Bytes Read(double deadline) override;
  void Write(ByteView bytes) override;
  void SetBaud(int baud) override;
  int baud() const override { return line_->baud(); }

 private:
  template <typename Call>
  void Recorded(LineRecord record, const Call& call);
  void Record(LineRecord record);

  std::unique_ptr<ByteStream> line_;
  std::function<void(const LineRecord&)> record_;
  double now_;
};

}  // namespace ariadne::drivers
