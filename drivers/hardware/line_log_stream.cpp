#include "drivers/hardware/line_log_stream.h"

#include <zstd.h>

#include <algorithm>
#include <boost/crc.hpp>
#include <cstring>
#include <string_view>

namespace ariadne::drivers {
namespace {

constexpr std::string_view kLineLogMagic = "ARIADLN2";  // what a file begins with
constexpr std::size_t kChunkHead = 8;                   // length and checksum [B]
constexpr std::size_t kRecordHead = 14;                 // line, kind, time, baud [B]
constexpr std::size_t kLongestRecord = 1U << 24U;       // [B]
constexpr std::size_t kZstdHead = 64;                   // of a stream, at most [B]
constexpr int kLevel = 3;       // higher ones take more time and save little on short records
constexpr int kWindowLog = 20;  // how far back the stream looks: 1 MB, some ten seconds of a scanner

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

/// Over length and chunk, so that zeros are no record.
std::uint32_t ChecksumOf(std::uint32_t length, ByteView chunk) {
  boost::crc_32_type crc;
  crc.process_bytes(&length, sizeof length);
  crc.process_bytes(chunk.data(), chunk.size());
  return crc.checksum();
}

Bytes PlainRecord(const LoggedRecord& logged) {
  Bytes plain = {logged.line, static_cast<std::uint8_t>(logged.record.kind)};
  plain.reserve(kRecordHead + logged.record.bytes.size());
  AppendNumber(plain, logged.record.time);
  AppendNumber(plain, static_cast<std::int32_t>(logged.record.baud));
  plain.insert(plain.end(), logged.record.bytes.begin(), logged.record.bytes.end());
  return plain;
}

std::optional<LoggedRecord> RecordIn(ByteView plain) {
  if (plain.size() < kRecordHead) return std::nullopt;
  if (plain[1] > static_cast<std::uint8_t>(LineRecord::Kind::kNote)) return std::nullopt;
  LoggedRecord logged;
  logged.line = plain[0];
  logged.record.kind = static_cast<LineRecord::Kind>(plain[1]);
  logged.record.time = NumberIn<double>(plain, 2);
  logged.record.baud = NumberIn<std::int32_t>(plain, 10);
  logged.record.bytes.assign(plain.begin() + kRecordHead, plain.end());
  return logged;
}

/// The chunk at a place of a file; none where it is torn or damaged.
std::optional<ByteView> ChunkAt(ByteView file, std::size_t at) {
  if (file.size() - at < kChunkHead) return std::nullopt;
  const auto length = NumberIn<std::uint32_t>(file, at);
  if (length == 0 || file.size() - at - kChunkHead < length) return std::nullopt;
  const ByteView chunk = file.subspan(at + kChunkHead, length);
  if (ChecksumOf(length, chunk) != NumberIn<std::uint32_t>(file, at + 4)) return std::nullopt;
  return chunk;
}

}  // namespace

struct LineLogEncoder::Stream {
  std::unique_ptr<ZSTD_CCtx, std::size_t (*)(ZSTD_CCtx*)> context{ZSTD_createCCtx(), &ZSTD_freeCCtx};
};

LineLogEncoder::LineLogEncoder() : stream_(std::make_unique<Stream>()) {
  ZSTD_CCtx_setParameter(stream_->context.get(), ZSTD_c_compressionLevel, kLevel);
  ZSTD_CCtx_setParameter(stream_->context.get(), ZSTD_c_windowLog, kWindowLog);
}

LineLogEncoder::~LineLogEncoder() = default;

Bytes LineLogEncoder::Begin() {
  ZSTD_CCtx_reset(stream_->context.get(), ZSTD_reset_session_only);
  return {kLineLogMagic.begin(), kLineLogMagic.end()};
}

Bytes LineLogEncoder::Add(const LoggedRecord& logged) {
  const Bytes plain = PlainRecord(logged);
  if (plain.size() > kLongestRecord) Fail("a record of {} bytes is too long for a log", plain.size());
  Bytes bytes(kChunkHead + ZSTD_compressBound(plain.size()) + kZstdHead);
  ZSTD_inBuffer in{plain.data(), plain.size(), 0};
  ZSTD_outBuffer out{bytes.data(), bytes.size(), kChunkHead};
  const std::size_t left = ZSTD_compressStream2(stream_->context.get(), &out, &in, ZSTD_e_flush);
  if (left != 0) Fail("a record of {} bytes could not be compressed", plain.size());
  bytes.resize(out.pos);
  const auto length = static_cast<std::uint32_t>(out.pos - kChunkHead);
  const std::uint32_t checksum = ChecksumOf(length, ByteView(bytes).subspan(kChunkHead));
  std::memcpy(bytes.data(), &length, sizeof length);
  std::memcpy(bytes.data() + 4, &checksum, sizeof checksum);
  return bytes;
}

struct LineLogDecoder::Stream {
  std::unique_ptr<ZSTD_DCtx, std::size_t (*)(ZSTD_DCtx*)> context{ZSTD_createDCtx(), &ZSTD_freeDCtx};
  Bytes part = Bytes(ZSTD_DStreamOutSize());

  /// What a chunk holds; none where it is none of this stream, or more than a record.
  std::optional<Bytes> Decompress(ByteView chunk) {
    Bytes plain;
    ZSTD_inBuffer in{chunk.data(), chunk.size(), 0};
    for (;;) {
      ZSTD_outBuffer out{part.data(), part.size(), 0};
      const std::size_t before = in.pos;
      if (ZSTD_isError(ZSTD_decompressStream(context.get(), &out, &in)) != 0) return std::nullopt;
      plain.insert(plain.end(), part.begin(), part.begin() + static_cast<std::ptrdiff_t>(out.pos));
      if (plain.size() > kLongestRecord) return std::nullopt;
      if (out.pos == 0 && in.pos == before) return std::nullopt;  // it does not go on
      if (in.pos == in.size && out.pos < out.size) return plain;
    }
  }
};

LineLogDecoder::LineLogDecoder(ByteView file) : file_(file), stream_(std::make_unique<Stream>()) {
  ZSTD_DCtx_setParameter(stream_->context.get(), ZSTD_d_windowLogMax, kWindowLog);
  const std::size_t known = std::min(file.size(), kLineLogMagic.size());
  if (!std::equal(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(known), kLineLogMagic.begin()))
    Fail("it is no log of lines, or one of another version");
  if (known == kLineLogMagic.size()) position_ = known;
}

LineLogDecoder::~LineLogDecoder() = default;

std::optional<LoggedRecord> LineLogDecoder::Next() {
  if (position_ == 0) return std::nullopt;  // not even the head is whole
  const std::optional<ByteView> chunk = ChunkAt(file_, position_);
  if (!chunk) return std::nullopt;
  const std::optional<Bytes> plain = stream_->Decompress(*chunk);
  std::optional<LoggedRecord> logged = plain ? RecordIn(*plain) : std::nullopt;
  if (logged) {
    position_ += kChunkHead + chunk->size();
  } else {
    file_ = file_.first(position_);
  }
  return logged;
}

}  // namespace ariadne::drivers
