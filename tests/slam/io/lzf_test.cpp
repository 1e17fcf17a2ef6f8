#include "slam/io/lzf.h"

#include <gtest/gtest.h>

#include <string>

#include "slam/base/random.h"

namespace ariadne::slam {
namespace {

std::string RandomBytes(std::size_t count, int kinds, const char* name) {
  RandomStream stream = NamedStream(3, name);
  std::string bytes(count, '\0');
  for (char& byte : bytes) byte = static_cast<char>(stream() % static_cast<unsigned>(kinds));
  return bytes;
}

std::vector<char> Compressed(const std::string& bytes) { return LzfCompressed(bytes); }

TEST(Lzf, RoundTrips) {
  for (const int kinds : {1, 3, 256}) {
    for (const std::size_t count : {0, 1, 2, 5, 31, 33, 1000, 100'000}) {
      const std::string bytes = RandomBytes(count, kinds, "round trip");
      const std::vector<char> compressed = Compressed(bytes);
      const auto again = LzfDecompressed({compressed.data(), compressed.size()}, count);
      ASSERT_TRUE(again.has_value()) << kinds << " kinds, " << count << " bytes";
      EXPECT_TRUE(std::equal(bytes.begin(), bytes.end(), again->begin(), again->end()));
      EXPECT_LE(count, LargestLzfOriginal(compressed.size()));
    }
  }
}

TEST(Lzf, ReachesItsLargestRatio) {
  const std::vector<char> compressed = Compressed(std::string(1'000'000, 'a'));
  EXPECT_GE(LargestLzfOriginal(compressed.size()), 1'000'000U);
  EXPECT_LT(LargestLzfOriginal(compressed.size()), 1'010'000U);
}

// The library does not clear its hash table; some ways to build it (ULTRA_FAST) then give other bytes.
TEST(Lzf, DoesNotDependOnWhatWasCompressedBefore) {
  const std::string bytes = RandomBytes(100'000, 3, "a");
  const std::vector<char> first = Compressed(bytes);
  for (const char* name : {"b", "c", "d"}) {
    Compressed(RandomBytes(100'000, 3, name));
    EXPECT_EQ(Compressed(bytes), first);
  }
}

TEST(Lzf, RefusesOtherSizes) {
  const std::vector<char> compressed = Compressed("abcabcabcabcabcabc");
  EXPECT_FALSE(LzfDecompressed({compressed.data(), compressed.size()}, 17));
  EXPECT_FALSE(LzfDecompressed({compressed.data(), compressed.size()}, 19));
  EXPECT_FALSE(LzfDecompressed({compressed.data(), compressed.size() - 1}, 18));
  EXPECT_FALSE(LzfDecompressed("", 1));
}

}  // namespace
}  // namespace ariadne::slam
