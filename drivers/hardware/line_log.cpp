#include "drivers/hardware/line_log.h"

#include <algorithm>
#include <boost/crc.hpp>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <optional>
#include <utility>

namespace ariadne::drivers {
namespace {

namespace fs = std::filesystem;

constexpr char kLineLogMagic[] = "ARIADLN1";  // what a file begins with
constexpr std::size_t kMagicSize = 8;         // [B]
constexpr std::size_t kFrameHead = 8;         // length and checksum [B]
constexpr std::size_t kRecordHead = 14;       // line, kind, time, baud [B]
constexpr std::size_t kLongestRecord = 1U << 24U;

fs::path FileOf(const fs::path& name, int number) { return name.string() + "." + std::to_string(number); }

template <typename T>
void AppendNumber(Bytes& bytes, const T& number) {
  const auto* data = reinterpret_cast<const std::uint8_t*>(&number);
  bytes.insert(bytes.end(), data, data + sizeof number);
}

template <typename T>
T NumberIn(ByteView bytes, std::size_t at) {
  T number;
  std::memcpy(&number, bytes.data() + at, sizeof number);
  return number;
}

/// Over length and payload, so that zeros are no record.
std::uint32_t ChecksumOf(std::uint32_t length, ByteView payload) {
  boost::crc_32_type crc;
  crc.process_bytes(&length, sizeof length);
  crc.process_bytes(payload.data(), payload.size());
  return crc.checksum();
}

Bytes ContentOfFile(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) Fail("cannot read {}", path.string());
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

Bytes EncodeLineRecord(std::uint8_t line, const LineRecord& record) {
  Bytes payload = {line, static_cast<std::uint8_t>(record.kind)};
  AppendNumber(payload, record.time);
  AppendNumber(payload, static_cast<std::int32_t>(record.baud));
  payload.insert(payload.end(), record.bytes.begin(), record.bytes.end());
  const auto length = static_cast<std::uint32_t>(payload.size());
  Bytes bytes;
  bytes.reserve(kFrameHead + payload.size());
  AppendNumber(bytes, length);
  AppendNumber(bytes, ChecksumOf(length, payload));
  bytes.insert(bytes.end(), payload.begin(), payload.end());
  return bytes;
}

std::optional<DecodedLineRecord> DecodeLineRecord(ByteView bytes) {
  if (bytes.size() < kFrameHead) return std::nullopt;
  const auto length = NumberIn<std::uint32_t>(bytes, 0);
  if (length < kRecordHead || length > kLongestRecord || bytes.size() - kFrameHead < length)
    return std::nullopt;
  const ByteView payload = bytes.subspan(kFrameHead, length);
  if (ChecksumOf(length, payload) != NumberIn<std::uint32_t>(bytes, 4)) return std::nullopt;
  if (payload[1] > static_cast<std::uint8_t>(LineRecord::Kind::kBaud)) return std::nullopt;
  DecodedLineRecord decoded;
  decoded.line = payload[0];
  decoded.record.kind = static_cast<LineRecord::Kind>(payload[1]);
  decoded.record.time = NumberIn<double>(payload, 2);
  decoded.record.baud = NumberIn<std::int32_t>(payload, 10);
  decoded.record.bytes.assign(payload.begin() + kRecordHead, payload.end());
  decoded.size = kFrameHead + length;
  return decoded;
}

LineLogWriter::LineLogWriter(fs::path name, std::uintmax_t max_file_size)
    : name_(std::move(name)), max_file_size_(max_file_size) {
  if (fs::exists(FileOf(name_, 0)))
    Fail("there is a log {} already; give the new one another name", name_.string());
  Open();
}

void LineLogWriter::Open() {
  const fs::path path = FileOf(name_, files_++);
  file_.reset(std::fopen(path.c_str(), "wbx"));
  if (file_ == nullptr) Fail("cannot write {}: {}", path.string(), std::strerror(errno));
  std::fwrite(kLineLogMagic, 1, kMagicSize, file_.get());
  size_ = kMagicSize;
}

void LineLogWriter::Add(std::uint8_t line, const LineRecord& record) {
  const Bytes bytes = EncodeLineRecord(line, record);
  if (size_ > kMagicSize && size_ + bytes.size() > max_file_size_) Open();
  const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) == bytes.size();
  if (!written || std::fflush(file_.get()) != 0) {
    Fail("cannot write {}: {}; make room on the disk", FileOf(name_, files_ - 1).string(),
         std::strerror(errno));
  }
  size_ += bytes.size();
}

std::map<std::uint8_t, std::vector<LineRecord>> ReadLineLog(const fs::path& name) {
  std::map<std::uint8_t, std::vector<LineRecord>> lines;
  for (int number = 0; number == 0 || fs::exists(FileOf(name, number)); ++number) {
    const fs::path path = FileOf(name, number);
    const Bytes content = ContentOfFile(path);
    const bool last = !fs::exists(FileOf(name, number + 1));
    const bool begins =
        content.size() >= kMagicSize && std::memcmp(content.data(), kLineLogMagic, kMagicSize) == 0;
    if (!begins && (content.size() >= kMagicSize || !last)) Fail("{} is no log of lines", path.string());
    std::size_t at = std::min(content.size(), kMagicSize);
    while (const auto decoded = DecodeLineRecord(ByteView(content).subspan(at))) {
      lines[decoded->line].push_back(decoded->record);
      at += decoded->size;
    }
    if (at < content.size() && !last) Fail("{} is damaged at byte {}", path.string(), at);
  }
  return lines;
}

}  // namespace ariadne::drivers
