#include "experiments/run/manifest.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/slam/io/support.h"

namespace ariadne::experiments {
namespace {

using slam::testing_support::ContentOf;
using slam::testing_support::ErrorOf;
using slam::testing_support::TemporaryFolder;
using testing::HasSubstr;
namespace fs = std::filesystem;

constexpr const char* kOfNothing = "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855";
constexpr const char* kOfAbc = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";

class ManifestTest : public testing::Test {
 protected:
  std::string HashOf(const std::string& content) { return Sha256OfFile(folder_.Write("file", content)); }
  TemporaryFolder folder_;
};

TEST_F(ManifestTest, HashesTheVectorsOfFips180) {
  EXPECT_EQ(HashOf(""), kOfNothing);
  EXPECT_EQ(HashOf("abc"), kOfAbc);
  EXPECT_EQ(HashOf("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(HashOf(std::string(1'000'000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST_F(ManifestTest, HashesFilesLongerThanItsBuffer) {
  EXPECT_EQ(HashOf(std::string(std::size_t{1} << 20, 'a')),
            "9bc1b2a288b26af7257a36277ae3816a7d4f16e89c1e7e77d0a5c48bad62b360");
  EXPECT_EQ(HashOf(std::string(3'000'000, 'a')),
            "2a152c894398719c0570f83fac34ac03a0f6e8e474b995c2403aa5434f7b9dd4");
}

TEST_F(ManifestTest, SaysWhichFileCannotBeHashed) {
  EXPECT_THAT(ErrorOf([&] { Sha256OfFile(folder_ / "none.3d"); }),
              HasSubstr("none.3d: there is no such file"));
}

TEST_F(ManifestTest, NamesWhatTheRunWasMadeWith) {
  const fs::path scan = folder_.Write("scan000.3d", "abc");
  const Json manifest = MakeManifest({scan});
  EXPECT_THAT(manifest.at("commit").get<std::string>(), testing::MatchesRegex("[0-9a-f]{40}|unknown"));
  EXPECT_TRUE(manifest.at("dirty").is_boolean());
  for (const char* key : {"compiler", "processor"})
    EXPECT_NE(manifest.at(key).get<std::string>(), "") << key;
  EXPECT_EQ(manifest.at("inputs"), (Json{{"scan000.3d", kOfAbc}}));
  EXPECT_TRUE(manifest.at("libraries").contains("eigen"));
}

TEST_F(ManifestTest, IsTheSameOnEachRun) {
  const fs::path scan = folder_.Write("scan000.3d", "abc");
  EXPECT_EQ(MakeManifest({scan}).dump(), MakeManifest({scan}).dump());
}

TEST_F(ManifestTest, LetsARunGoOnOnlyWithTheScansThatItHasUsed) {
  const std::vector<fs::path> scans{folder_.Write("in/a.xyz", "1"), folder_.Write("in/b.xyz", "2")};
  const RunDirectory run(folder_ / "run", RunDirectory::Existing::kRefuse);
  WriteManifest(run, scans);
  folder_.Write("in/b.xyz", "mended");
  EXPECT_NO_THROW(WriteManifest(run, scans, 1)) << "b was not used yet";
  EXPECT_THAT(run.ReadText("manifest.json"), HasSubstr(Sha256OfFile(scans[1])));
  folder_.Write("in/a.xyz", "changed");
  EXPECT_THAT(ErrorOf([&] { WriteManifest(run, scans, 1); }), HasSubstr("a.xyz: has changed since"));
  EXPECT_NO_THROW(WriteManifest(run, scans, 0));
}

}  // namespace
}  // namespace ariadne::experiments
