#pragma once

#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <ostream>

namespace ariadne::slam {

/// Opens a file for reading. A file that is missing, a folder, or not readable is an Error that says so.
std::ifstream OpenForReading(const std::filesystem::path& path);

/// Reads a file with one of the functions on streams: `ReadFile(path, ReadUosPose)`.
template <typename Read>
auto ReadFile(const std::filesystem::path& path, const Read& read) {
  std::ifstream in = OpenForReading(path);
  return read(in, path.string());
}

class DescriptorBuffer;

/// A file that appears under its name only when it is complete: until Commit it grows under a temporary
/// name in the same folder, and the old file stays as it is. What is not a plain file (a device, a pipe,
/// a link such as /dev/stdout) is written directly.
class AtomicFile {
 public:
  /// Error where the file cannot be created.
  explicit AtomicFile(std::filesystem::path path);
  /// Without Commit nothing remains.
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Every write that fails throws an Error with the path and the system's reason, so that its users
  /// need not look at the state of the stream.
  std::ostream& stream() { return stream_; }

  /// Flushes to the disk and gives the file its name.
  void Commit();

 private:
  std::filesystem::path path_;
  std::filesystem::path temporary_;  // empty when there is nothing to remove or to rename
  std::unique_ptr<DescriptorBuffer> buffer_;
  std::ostream stream_;
};

/// Writes a file at once or not at all: `WriteFileAtomically(path, [&](std::ostream& out) {...})`.
void WriteFileAtomically(const std::filesystem::path& path,
                         const std::function<void(std::ostream&)>& write);

}  // namespace ariadne::slam
