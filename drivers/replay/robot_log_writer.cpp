#include <fcntl.h>

#include <cstring>
#include <system_error>

#include "drivers/replay/call_bytes.h"
#include "drivers/replay/log_frame.h"
#include "drivers/replay/robot_log.h"
#include "slam/base/error.h"

namespace ariadne::drivers {
namespace {

namespace fs = std::filesystem;

/// Cuts off what is torn at the end of a log; its size then, 0 where there is none.
std::uint64_t WholeSizeOf(const fs::path& path) {
  std::error_code ignored;  // opening it will say what is wrong
  if (!fs::is_regular_file(path, ignored)) return 0;
  const RobotLog log = ReadRobotLog(path);
  if (log.torn_at()) {
    std::error_code error;
    fs::resize_file(path, log.end(), error);
    if (error) slam::FailToWrite(path, error.value());
  }
  return log.end();
}

std::string HeadOfLog() {
  std::string head(kRobotLogMagic);
  head.append(reinterpret_cast<const char*>(&kRobotLogVersion), sizeof kRobotLogVersion);
  return head;
}

}  // namespace

RobotLogWriter::RobotLogWriter(fs::path path)
    : path_(std::move(path)),
      begun_(WholeSizeOf(path_) > 0),
      file_(path_, O_WRONLY | O_CREAT | O_APPEND, path_) {
  if (!begun_) Write(HeadOfLog());
  Flush();
}

void RobotLogWriter::Append(const RobotCall& call) {
  const std::string payload = EncodeCall(call);
  FrameHead head;
  head.length = static_cast<std::uint32_t>(payload.size());
  head.crc = FrameCrc(head.length, payload);
  std::string frame(reinterpret_cast<const char*>(&head), sizeof head);
  frame += payload;
  Write(frame);
  const CallKind kind = KindOf(call);
  if (kind == CallKind::kScan || kind == CallKind::kNote) Flush();
}

void RobotLogWriter::Flush() {
  if (failed_) Fail("{}: could not be written before; the log ends there", path_.string());
  failed_ = true;  // until it is done
  file_.FlushToDisk();
  failed_ = false;
}

void RobotLogWriter::Write(std::string_view bytes) {
  if (failed_) Fail("{}: could not be written before; the log ends there", path_.string());
  failed_ = true;  // until it is done: behind half a record nothing could be read
  file_.sputn(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file_.pubsync();
  failed_ = false;
}

}  // namespace ariadne::drivers
