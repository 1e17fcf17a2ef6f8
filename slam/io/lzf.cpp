#include "slam/io/lzf.h"

#include <liblzf/lzf.h>

#include "slam/io/huge_pages.h"

namespace ariadne::slam {

std::vector<char> LzfCompressed(std::string_view bytes) {
  if (bytes.empty()) return {};
  // 32 bytes that repeat nothing take 33.
  std::vector<char> compressed(bytes.size() + bytes.size() / 32 + 16);
  compressed.resize(lzf_compress(bytes.data(), static_cast<unsigned>(bytes.size()), compressed.data(),
                                 static_cast<unsigned>(compressed.size())));
  return compressed;
}

std::optional<std::vector<char>> LzfDecompressed(std::string_view compressed, std::size_t size) {
  if (compressed.empty() || size == 0) return size == 0 ? std::optional(std::vector<char>()) : std::nullopt;
  std::vector<char> bytes;
  ReserveInHugePages(bytes, size);
  bytes.resize(size);
  const unsigned written = lzf_decompress(compressed.data(), static_cast<unsigned>(compressed.size()),
                                          bytes.data(), static_cast<unsigned>(size));
  if (written != size) return std::nullopt;
  return bytes;
}

}  // namespace ariadne::slam
