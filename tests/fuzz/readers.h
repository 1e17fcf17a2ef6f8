#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace ariadne::fuzz {

/// An entry point of slam/io, drivers/replay or drivers/hardware for bytes that nobody has looked at.
struct Reader {
  std::string_view name;  // of the fuzzer and of the folder of its corpus
  /// Whether the bytes are read. What was read is written, read, and written again: both writings must be
  /// the same bytes. An Error is the proper answer to damage; any other exception, or another second
  /// writing, is a bug and leaves this function as an exception.
  bool (*accepts)(std::string_view bytes);
};

std::span<const Reader> Readers();

/// The body of a fuzzer: LLVMFuzzerTestOneInput for the reader of this name.
int Feed(std::string_view reader, const std::uint8_t* data, std::size_t size);

}  // namespace ariadne::fuzz
