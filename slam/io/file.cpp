#include "slam/io/file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include "slam/base/error.h"
#include "slam/io/descriptor_buffer.h"

namespace ariadne::slam {
namespace {

namespace fs = std::filesystem;

/// A name beside the file that belongs to this process; O_EXCL below guards against any other use.
fs::path TemporaryBeside(const fs::path& path) {
  for (int attempt = 0;; ++attempt) {
    fs::path temporary = fmt::format("{}.{}-{}.partial", path.string(), getpid(), attempt);
    std::error_code ignored;  // opening will say what is wrong
    if (!fs::exists(fs::symlink_status(temporary, ignored))) return temporary;
  }
}

/// Where the bytes go first: a new file beside the path, or (empty) straight to what is not a plain file.
fs::path TemporaryFor(const fs::path& path) {
  std::error_code ignored;  // whatever is wrong with the path, opening it will say so
  if (fs::is_directory(path, ignored)) {
    Fail("{}: cannot be written: it is a folder; name a file in it", path.string());
  }
  const fs::file_status status = fs::symlink_status(path, ignored);
  if (fs::exists(status) && !fs::is_regular_file(status)) return {};
  return TemporaryBeside(path);
}

std::unique_ptr<DescriptorBuffer> OpenForWriting(const fs::path& path, const fs::path& temporary) {
  if (temporary.empty()) {
    return std::make_unique<DescriptorBuffer>(path, O_WRONLY | O_CREAT | O_TRUNC, path);
  }
  return std::make_unique<DescriptorBuffer>(temporary, O_WRONLY | O_CREAT | O_EXCL, path);
}

}  // namespace

std::ifstream OpenForReading(const fs::path& path) {
  std::error_code ignored;  // opening says what is wrong
  if (fs::is_directory(path, ignored)) Fail("{}: is a folder where a file is expected", path.string());
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  if (in) return in;
  if (errno == ENOENT) Fail("{}: there is no such file; check the path", path.string());
  Fail("{}: cannot be read: {}; check the path and its permissions", path.string(), std::strerror(errno));
}

AtomicFile::AtomicFile(fs::path path)
    : path_(std::move(path)),
      temporary_(TemporaryFor(path_)),
      buffer_(OpenForWriting(path_, temporary_)),
      stream_(buffer_.get()) {
  stream_.exceptions(std::ios::badbit);  // lets the Error of the buffer through
}

AtomicFile::~AtomicFile() {
  std::error_code ignored;  // a destructor has nobody to tell
  if (!temporary_.empty()) fs::remove(temporary_, ignored);
}

void AtomicFile::Commit() {
  buffer_->FlushToDisk();
  if (temporary_.empty()) return;
  std::error_code error;
  fs::rename(temporary_, path_, error);
  if (error) FailToWrite(path_, error.value());
  temporary_.clear();
}

void WriteFileAtomically(const fs::path& path, const std::function<void(std::ostream&)>& write) {
  AtomicFile file(path);
  write(file.stream());
  file.Commit();
}

}  // namespace ariadne::slam
