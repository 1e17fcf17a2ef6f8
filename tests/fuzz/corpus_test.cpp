// Replays the corpus of the fuzzers: every file through every reader, as CI can with any compiler.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include "tests/fuzz/readers.h"

namespace ariadne::fuzz {
namespace {

namespace fs = std::filesystem;

const fs::path kCorpus = fs::path(ARIADNE_SOURCE_DIR) / "tests/fuzz/corpus";

std::string ContentOf(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(Corpus, HarmsNoReader) {
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(kCorpus)) {
    if (!entry.is_regular_file()) continue;
    const std::string content = ContentOf(entry.path());
    for (const Reader& reader : Readers()) {
      EXPECT_NO_THROW(reader.accepts(content)) << reader.name << " reading " << entry.path();
    }
  }
}

/// The folder of a reader has files that it must accept (good_...), files that it must refuse (bad_...),
/// and files that were found by fuzzing (found_...).
TEST(Corpus, IsJudgedByItsOwnReader) {
  for (const Reader& reader : Readers()) {
    std::set<std::string> kinds;
    for (const fs::directory_entry& entry : fs::directory_iterator(kCorpus / reader.name)) {
      const std::string name = entry.path().filename().string();
      const std::string kind = name.substr(0, name.find('_'));
      kinds.insert(kind);
      if (kind == "found") continue;
      EXPECT_EQ(reader.accepts(ContentOf(entry.path())), kind == "good") << entry.path();
    }
    EXPECT_TRUE(kinds.contains("good") && kinds.contains("bad")) << reader.name;
  }
}

}  // namespace
}  // namespace ariadne::fuzz
