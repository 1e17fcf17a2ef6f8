#include "tests/fuzz/readers.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return ariadne::fuzz::Feed("roboclaw_reply", data, size);
}
