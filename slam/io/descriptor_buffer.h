#pragma once

#include <filesystem>
#include <streambuf>
#include <vector>

namespace ariadne::slam {

/// The buffer of an output stream on a file descriptor. Where std::filebuf forgets why a write failed,
/// this one throws an Error with the path and the reason.
class DescriptorBuffer final : public std::streambuf {
 public:
  /// Opens the file with the flags of open(2); `path_in_messages` is the name that the user knows.
  DescriptorBuffer(const std::filesystem::path& file, int flags, std::filesystem::path path_in_messages);
  ~DescriptorBuffer() override;
  DescriptorBuffer(const DescriptorBuffer&) = delete;
  DescriptorBuffer& operator=(const DescriptorBuffer&) = delete;

  /// Writes what is buffered and waits until the disk has it.
  void FlushToDisk();

 protected:
  int_type overflow(int_type character) override;
  std::streamsize xsputn(const char* bytes, std::streamsize count) override;
  int sync() override;

 private:
  void Write(const char* bytes, std::size_t count);

  std::filesystem::path path_;
  std::vector<char> memory_;
  int descriptor_;
};

/// Throws the Error of a file that cannot be written, with the reason of an `errno`.
[[noreturn]] void FailToWrite(const std::filesystem::path& path, int reason);

}  // namespace ariadne::slam
