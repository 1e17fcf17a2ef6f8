#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "drivers/replay/log_frame.h"
#include "drivers/replay/robot_log.h"
#include "slam/base/error.h"

namespace ariadne::drivers {
namespace {

namespace fs = std::filesystem;

/// Cuts off what is torn at the end of a log. Its size then; 0 where there is no log.
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

/// That a new file has its name is on the disk only when its folder is.
void FlushFolderOf(const fs::path& path) {
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;  // who may write to a folder need not be allowed to list it
  fsync(descriptor);           // some file systems cannot
  close(descriptor);
}

}  // namespace

LogLock::LogLock(const fs::path& path) : descriptor_(open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
  if (descriptor_ < 0 || flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  close(descriptor_);
  Fail("{}: another program is writing this log; let it end first", path.string());
}

LogLock::~LogLock() {
  if (descriptor_ >= 0) close(descriptor_);
}

RobotLogWriter::RobotLogWriter(fs::path path)
    : path_(std::move(path)), file_(path_, O_WRONLY | O_CREAT | O_APPEND, path_), lock_(path_) {
  if (WholeSizeOf(path_) > 0) return;
  Write(HeadOfLog());
  Flush();
  FlushFolderOf(path_);
}

void RobotLogWriter::Append(const RobotCall& call) {
  Write(FramedCall(call));
  if (IsSafeAtOnce(KindOf(call))) Flush();
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
