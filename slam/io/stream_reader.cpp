#include "slam/io/stream_reader.h"

#include <algorithm>
#include <cstring>

namespace ariadne::slam {
namespace {

/// From where the stream stands to its end; unknown where it cannot be rewound, or where it claims to be
/// empty (as the files of /proc and devices do).
std::optional<std::uint64_t> SizeOfRest(std::istream& in) {
  const std::istream::pos_type start = in.tellg();
  in.seekg(0, std::ios::end);
  const std::istream::pos_type end = in.tellg();
  in.clear();
  if (start == std::istream::pos_type(-1) || end <= start) return std::nullopt;
  in.seekg(start);
  return static_cast<std::uint64_t>(end - start);
}

}  // namespace

StreamReader::StreamReader(std::istream& in, std::string name)
    : in_(in),
      name_(std::move(name)),
      size_(SizeOfRest(in)),
      // A pose file of 50 bytes should not cost a megabyte.
      capacity_(
          static_cast<std::size_t>(std::min<std::uint64_t>(kChunkSize, size_.value_or(kChunkSize) + 1))),
      buffer_(std::make_unique_for_overwrite<char[]>(capacity_)) {}

std::optional<std::uint64_t> StreamReader::Remaining() const {
  if (!size_) return std::nullopt;
  return *size_ - std::min(*size_, offset_);
}

std::optional<std::string_view> StreamReader::NextLine() {
  const std::optional<LineExtent> found = FindLine();
  if (!found) return std::nullopt;
  const std::string_view text(buffer_.get() + begin_, found->text_size);
  Consume(found->size);
  ++line_;
  return text;
}

std::optional<std::string_view> StreamReader::PeekLine() {
  const std::optional<LineExtent> found = FindLine();
  if (!found) return std::nullopt;
  return std::string_view(buffer_.get() + begin_, found->text_size);
}

std::string_view StreamReader::NextBytes(std::size_t count) {
  if (end_ - begin_ < count) FillBuffer();
  const std::string_view bytes(buffer_.get() + begin_, std::min(count, end_ - begin_));
  Consume(bytes.size());
  return bytes;
}

std::optional<StreamReader::LineExtent> StreamReader::FindLine() {
  const auto find_end = [&](std::size_t from) {
    const std::size_t start = begin_ + from;
    return static_cast<const char*>(std::memchr(buffer_.get() + start, '\n', end_ - start));
  };
  const char* line_end = find_end(0);
  if (line_end == nullptr) {
    const std::size_t searched = end_ - begin_;
    FillBuffer();
    line_end = find_end(searched);
  }
  if (line_end == nullptr && end_ - begin_ == capacity_) {
    Fail("{}:{}: the line is longer than {} bytes; this is not a text file", name_, line_ + 1, capacity_);
  }
  if (begin_ == end_) return std::nullopt;
  const char* begin = buffer_.get() + begin_;
  const char* text_end = line_end != nullptr ? line_end : buffer_.get() + end_;
  const auto size = static_cast<std::size_t>(text_end - begin) + (line_end != nullptr ? 1 : 0);
  if (text_end != begin && text_end[-1] == '\r') --text_end;
  return LineExtent{size, static_cast<std::size_t>(text_end - begin)};
}

void StreamReader::FillBuffer() {
  std::memmove(buffer_.get(), buffer_.get() + begin_, end_ - begin_);
  end_ -= begin_;
  begin_ = 0;
  in_.read(buffer_.get() + end_, static_cast<std::streamsize>(capacity_ - end_));
  end_ += static_cast<std::size_t>(in_.gcount());
  if (in_.bad()) FailAtByte(offset_ + end_, "the system cannot read on; check the disk");
}

void StreamReader::Consume(std::size_t count) {
  begin_ += count;
  offset_ += count;
}

std::optional<std::size_t> CountLineEnds(std::istream& in) {
  const std::istream::pos_type start = in.tellg();
  if (start == std::istream::pos_type(-1)) {
    in.clear();
    return std::nullopt;
  }
  constexpr std::size_t kPiece = 1 << 16;  // [B]
  const auto chunk = std::make_unique_for_overwrite<char[]>(kPiece);
  std::size_t count = 0;
  do {
    in.read(chunk.get(), kPiece);
    count += static_cast<std::size_t>(std::count(chunk.get(), chunk.get() + in.gcount(), '\n'));
  } while (in);
  in.clear();
  in.seekg(start);
  return count;
}

std::string Quoted(std::string_view piece) {
  constexpr std::size_t kLongest = 40;
  std::string quoted = "'";
  for (const char c : piece.substr(0, kLongest)) {
    const bool printable = c >= ' ' && c <= '~';
    quoted += printable ? std::string(1, c) : fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
  }
  return quoted + (piece.size() > kLongest ? "...'" : "'");
}

}  // namespace ariadne::slam
