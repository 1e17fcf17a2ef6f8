#include "slam/io/descriptor_buffer.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string_view>
#include <utility>

#include "slam/base/error.h"

namespace ariadne::slam {
namespace {

constexpr std::size_t kBufferSize = 1 << 16;

std::string_view Remedy(int reason) {
  switch (reason) {
    case ENOENT:
      return "; create its folder first";
    case EACCES:
    case EPERM:
    case EROFS:
      return "; choose a folder that you may write to";
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
      return "; free some space or choose another disk";
    default:
      return "";
  }
}

}  // namespace

void FailToWrite(const std::filesystem::path& path, int reason) {
  Fail("{}: cannot be written: {}{}", path.string(), std::strerror(reason), Remedy(reason));
}

DescriptorBuffer::DescriptorBuffer(const std::filesystem::path& file, int flags,
                                   std::filesystem::path path_in_messages)
    : path_(std::move(path_in_messages)),
      memory_(kBufferSize),
      descriptor_(open(file.c_str(), flags | O_CLOEXEC, 0666)) {
  if (descriptor_ < 0) FailToWrite(path_, errno);
  setp(memory_.data(), memory_.data() + memory_.size());
}

DescriptorBuffer::~DescriptorBuffer() { close(descriptor_); }

void DescriptorBuffer::FlushToDisk() {
  sync();
  // Pipes and devices have no disk to wait for and answer EINVAL (or EROFS, see fsync(2)).
  if (fsync(descriptor_) != 0 && errno != EINVAL && errno != EROFS) FailToWrite(path_, errno);
}

DescriptorBuffer::int_type DescriptorBuffer::overflow(int_type character) {
  sync();
  if (!traits_type::eq_int_type(character, traits_type::eof())) sputc(traits_type::to_char_type(character));
  return traits_type::not_eof(character);
}

std::streamsize DescriptorBuffer::xsputn(const char* bytes, std::streamsize count) {
  if (count > epptr() - pptr()) sync();
  if (count > epptr() - pptr()) {
    Write(bytes, static_cast<std::size_t>(count));
  } else {
    std::memcpy(pptr(), bytes, static_cast<std::size_t>(count));
    pbump(static_cast<int>(count));
  }
  return count;
}

int DescriptorBuffer::sync() {
  const auto count = static_cast<std::size_t>(pptr() - pbase());
  setp(memory_.data(), memory_.data() + memory_.size());
  Write(memory_.data(), count);
  return 0;
}

void DescriptorBuffer::Write(const char* bytes, std::size_t count) {
  while (count > 0) {
    const ssize_t written = write(descriptor_, bytes, count);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) FailToWrite(path_, errno);
    bytes += written;
    count -= static_cast<std::size_t>(written);
  }
}

}  // namespace ariadne::slam
