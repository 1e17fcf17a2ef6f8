#include "slam/io/pcd_compressed.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string_view>
#include <utility>

#include "slam/io/huge_pages.h"
#include "slam/io/lzf.h"

namespace ariadne::slam {
namespace {

std::uint32_t ReadUint32(StreamReader& reader) {
  const std::string_view bytes = reader.NextBytes(sizeof(std::uint32_t));
  std::uint32_t number = 0;
  if (bytes.size() < sizeof(number)) {
    reader.FailAtByte(reader.offset(), "the file ends before the compressed points");
  }
  std::memcpy(&number, bytes.data(), sizeof(number));
  return number;
}

std::vector<char> ReadBytes(StreamReader& reader, std::uint64_t count) {
  if (count > reader.Remaining().value_or(count)) {
    reader.FailAtByte(reader.offset(),
                      "{} compressed bytes are announced, but only {} follow; the file is truncated", count,
                      *reader.Remaining());
  }
  std::vector<char> bytes;
  if (reader.Remaining()) ReserveInHugePages(bytes, static_cast<std::size_t>(count));
  while (bytes.size() < count) {
    const auto piece =
        reader.NextBytes(std::min<std::uint64_t>(count - bytes.size(), StreamReader::kChunkSize));
    if (piece.empty()) reader.FailAtByte(reader.offset(), "the file ends within the compressed points");
    bytes.insert(bytes.end(), piece.begin(), piece.end());
  }
  return bytes;
}

}  // namespace

std::vector<char> ReadCompressedFields(StreamReader& reader, const PcdHeader& header) {
  const std::uint32_t compressed_size = ReadUint32(reader);
  const std::uint32_t size = ReadUint32(reader);
  const std::uint64_t start = reader.offset();
  if (header.points != size / header.layout.stride || size % header.layout.stride != 0) {
    reader.FailAtByte(start - 4, "{} bytes of points are announced, but {} points have {} each", size,
                      header.points, header.layout.stride);
  }
  if (size > LargestLzfOriginal(compressed_size)) {
    reader.FailAtByte(start - 8, "{} compressed bytes cannot hold {}; the file is damaged", compressed_size,
                      size);
  }
  const std::vector<char> compressed = ReadBytes(reader, compressed_size);
  std::optional<std::vector<char>> fields = LzfDecompressed({compressed.data(), compressed.size()}, size);
  if (!fields) reader.FailAtByte(start, "the compressed points are damaged");
  return *std::move(fields);
}

}  // namespace ariadne::slam
