#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "drivers/hardware/byte_stream.h"

namespace ariadne::drivers {

/// One call to a line, and when it returned.
struct LineRecord {
  enum class Kind : std::uint8_t { kOpen, kRead, kWrite, kBaud };

  Kind kind = Kind::kRead;
  double time = 0.0;  // [s], of the line
  Bytes bytes;        // read (perhaps none) or written; of kOpen the line's name
  int baud = 0;       // of kOpen and kBaud

  bool operator==(const LineRecord&) const = default;
};

/// A line whose calls are handed to `record` as they return, after one that says that it was opened. Its
/// clock shows the time of the last one and goes on with the next, so that who talks over it decides by
/// nothing that is not recorded.
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
  void Record(LineRecord record);

  std::unique_ptr<ByteStream> line_;
  std::function<void(const LineRecord&)> record_;
  double now_;
};

/// The same calls once more, from their records. Error where the caller does anything else than when it was
/// recorded, or more, or where the first record is of no opening.
class RecordedStream : public ByteStream {
 public:
  explicit RecordedStream(std::vector<LineRecord> records);

  std::string name() const override { return name_; }
  double Now() const override { return now_; }
  Bytes Read(double deadline) override;
  void Write(ByteView bytes) override;
  void SetBaud(int baud) override;
  int baud() const override { return baud_; }

  std::size_t left() const { return records_.size() - next_; }

 private:
  const LineRecord& Take(LineRecord::Kind kind);

  std::string name_;
  std::vector<LineRecord> records_;
  std::size_t next_ = 0;
  double now_ = 0.0;
  int baud_ = 9600;
};

}  // namespace ariadne::drivers
