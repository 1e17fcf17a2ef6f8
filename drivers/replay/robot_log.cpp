#include "drivers/replay/robot_log.h"

#include <algorithm>
#include <cstring>
#include <fstream>

#include "drivers/replay/log_frame.h"
#include "slam/base/error.h"
#include "slam/io/file.h"

namespace ariadne::drivers {
namespace {

constexpr std::uint64_t kSearchedTail = 4 << 20;  // several scans and what lies between them [B]

/// Whether a whole record begins here after which the writer waited for the disk.
bool HasSafeRecord(std::string_view bytes) {
  FrameHead head;
  if (bytes.size() < sizeof head) return false;
  std::memcpy(&head, bytes.data(), sizeof head);
  const std::string_view payload = bytes.substr(sizeof head, head.length);
  if (head.length == 0 || payload.size() < head.length) return false;
  const std::optional<CallKind> kind = KindOfBytes(payload);
  return kind && IsSafeAtOnce(*kind) && FrameCrc(head.length, payload) == head.crc;
}

std::uint64_t SizeOfFile(std::istream& file, const std::string& name) {
  file.seekg(0, std::ios::end);
  const auto size = static_cast<std::streamoff>(file.tellg());
  file.seekg(0);
  if (!file || size < 0) Fail("{}: cannot be searched; a log is a plain file", name);
  return static_cast<std::uint64_t>(size);
}

}  // namespace

RobotLog::RobotLog(std::unique_ptr<std::istream> file, std::string name)
    : file_(std::move(file)), name_(std::move(name)) {
  const std::uint64_t size = SizeOfFile(*file_, name_);
  CheckHead(size);
  while (end_ >= kRobotLogHeadSize && FindRecord(size)) {
  }
  if (end_ == size) return;
  CheckTail(size);
  torn_at_ = end_;
}

void RobotLog::CheckHead(std::uint64_t file_size) {
  const std::string_view head = BytesAt(0, std::min<std::uint64_t>(file_size, kRobotLogHeadSize));
  const std::string_view magic = head.substr(0, kRobotLogMagic.size());
  if (magic != kRobotLogMagic.substr(0, magic.size())) {
    Fail("{}: is not the log of a robot; name the log of a run", name_);
  }
  if (head.size() < kRobotLogHeadSize) return;  // the program ended when it had just begun
  std::uint32_t version = 0;
  std::memcpy(&version, head.data() + kRobotLogMagic.size(), sizeof version);
  if (version != kRobotLogVersion) {
    Fail("{}: is a log of version {}, and this program reads version {}; use the one that wrote it", name_,
         version, kRobotLogVersion);
  }
  end_ = kRobotLogHeadSize;
}

/// Whether there is one more whole record at end_.
bool RobotLog::FindRecord(std::uint64_t file_size) {
  if (file_size - end_ < sizeof(FrameHead)) return false;
  FrameHead head;
  std::memcpy(&head, BytesAt(end_, sizeof head).data(), sizeof head);
  const std::uint64_t offset = end_ + sizeof head;
  if (head.length == 0 || head.length > file_size - offset) return false;
  const std::string_view payload = BytesAt(offset, head.length);
  if (FrameCrc(head.length, payload) != head.crc) return false;
  const std::optional<CallKind> kind = KindOfBytes(payload);
  if (!kind) {
    Fail("{}: byte {}: a record of a kind that this program does not know; use the one that wrote it",
         name_, end_);
  }
  records_.push_back({offset, head.length, *kind});
  end_ = offset + head.length;
  return true;
}

/// Error where what is torn at end_ is not the end of the log.
void RobotLog::CheckTail(std::uint64_t file_size) {
  const std::uint64_t begin = end_ + 1;
  if (begin >= file_size) return;
  const std::string_view tail = BytesAt(begin, std::min(file_size - begin, kSearchedTail));
  for (std::size_t i = 0; i < tail.size(); ++i) {
    if (!HasSafeRecord(tail.substr(i))) continue;
    Fail(
        "{}: byte {}: the log is damaged there, and goes on at byte {}; restore it from a copy, or give up "
        "what "
        "follows: truncate -s {} {}",
        name_, end_, begin + i, end_, name_);
  }
}

RobotCall RobotLog::Read(std::size_t i) {
  const Record& record = records_.at(i);
  try {
    return DecodeCall(BytesAt(record.offset, record.length));
  } catch (const Error& error) {
    Fail("{}: byte {}: {}", name_, record.offset, error.what());
  }
}

std::string_view RobotLog::BytesAt(std::uint64_t offset, std::size_t count) {
  memory_.resize(count);
  if (position_ != offset) file_->seekg(static_cast<std::streamoff>(offset));  // which empties its buffer
  file_->read(memory_.data(), static_cast<std::streamsize>(count));
  if (!*file_) Fail("{}: byte {}: the system cannot read on; check the disk", name_, offset);
  position_ = offset + count;
  return {memory_.data(), count};
}

RobotLog ReadRobotLog(const std::filesystem::path& path) {
  auto file = std::make_unique<std::ifstream>(slam::OpenForReading(path));
  return {std::move(file), path.string()};
}

}  // namespace ariadne::drivers
