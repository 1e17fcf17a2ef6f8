#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace ariadne::slam {

/// The library counts in 32 bits. [B]
constexpr std::size_t kLargestLzfInput = std::size_t{1} << 31;

/// LZF (liblzf), the compression of PCD files. The same bytes give the same compressed bytes.
std::vector<char> LzfCompressed(std::string_view bytes);

/// The original of `size` bytes, or nothing where the compressed bytes do not give just that.
std::optional<std::vector<char>> LzfDecompressed(std::string_view compressed, std::size_t size);

/// No original is larger than this. Three bytes can stand for 264 at most.
inline std::size_t LargestLzfOriginal(std::size_t compressed_size) { return 88 * compressed_size; }

}  // namespace ariadne::slam
