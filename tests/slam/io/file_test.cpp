#include "slam/io/file.h"

#include <gmock/gmock.h>
#include <sys/resource.h>

#include <csignal>

#include "tests/slam/io/support.h"

namespace ariadne::slam {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing_support::ContentOf;
using testing_support::ErrorOf;
using testing_support::TemporaryFolder;
namespace fs = std::filesystem;

void WriteText(const fs::path& path, const std::string& text) {
  WriteFileAtomically(path, [&](std::ostream& out) { out << text; });
}

std::size_t FilesIn(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
}

/// Limits the size of files, which is how a disk that fills up looks to a program.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) {
    getrlimit(RLIMIT_FSIZE, &old_);
    const rlimit limited{bytes, old_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limited);
    std::signal(SIGXFSZ, SIG_IGN);
  }
  ~FullDisk() { setrlimit(RLIMIT_FSIZE, &old_); }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  rlimit old_{};
};

TEST(OpenForReading, SaysWhyItCannot) {
  const TemporaryFolder folder;
  EXPECT_THAT(ErrorOf([&] { OpenForReading(folder / "a.pcd"); }),
              HasSubstr("a.pcd: there is no such file"));
  EXPECT_THAT(ErrorOf([&] { OpenForReading(folder.path()); }),
              HasSubstr("is a folder where a file is expected"));
  fs::create_symlink(folder / "loop", folder / "loop");
  EXPECT_THAT(ErrorOf([&] { OpenForReading(folder / "loop"); }),
              HasSubstr("symbolic links; check the path"));
}

TEST(OpenForReading, SaysThatPermissionIsMissing) {
  if (geteuid() == 0) GTEST_SKIP() << "root may read everything";
  const TemporaryFolder folder;
  fs::permissions(folder.Write("secret", "x"), fs::perms::none);
  EXPECT_THAT(ErrorOf([&] { OpenForReading(folder / "secret"); }), HasSubstr("Permission denied"));
}

TEST(WriteFileAtomically, ReplacesTheFile) {
  const TemporaryFolder folder;
  folder.Write("file", "old and longer");
  WriteText(folder / "file", "new");
  EXPECT_EQ(ContentOf(folder / "file"), "new");
  EXPECT_EQ(FilesIn(folder.path()), 1U);
}

TEST(WriteFileAtomically, WritesMoreThanItsBuffer) {
  const TemporaryFolder folder;
  std::string text;
  while (text.size() < 300'000) text += std::to_string(text.size()) + ' ';
  WriteFileAtomically(folder / "file", [&](std::ostream& out) {
    out << text[0];
    out.write(text.data() + 1, 1000);
    out.write(text.data() + 1001, static_cast<std::streamsize>(text.size()) - 1001);
  });
  EXPECT_EQ(ContentOf(folder / "file"), text);
}

TEST(WriteFileAtomically, KeepsTheOldFileWhenTheWriterFails) {
  const TemporaryFolder folder;
  folder.Write("file", "old");
  const auto write = [](std::ostream& out) {
    out << "half of the new";
    Fail("no more");
  };
  EXPECT_EQ(ErrorOf([&] { WriteFileAtomically(folder / "file", write); }), "no more");
  EXPECT_EQ(ContentOf(folder / "file"), "old");
  EXPECT_EQ(FilesIn(folder.path()), 1U);
}

TEST(WriteFileAtomically, KeepsTheOldFileWhenTheDiskIsFull) {
  const TemporaryFolder folder;
  folder.Write("file", "old");
  std::string message;
  {
    const FullDisk disk(1000);
    message = ErrorOf([&] { WriteText(folder / "file", std::string(100'000, 'x')); });
  }
  EXPECT_THAT(message, HasSubstr("file: cannot be written: File too large; free some space"));
  EXPECT_EQ(ContentOf(folder / "file"), "old");
  EXPECT_EQ(FilesIn(folder.path()), 1U);
}

TEST(WriteFileAtomically, SaysWhyItCannot) {
  const TemporaryFolder folder;
  EXPECT_THAT(ErrorOf([&] { WriteText(folder / "no/file", "x"); }),
              HasSubstr("no/file: cannot be written: No such file or directory; create its folder first"));
  EXPECT_THAT(ErrorOf([&] { WriteText(folder.path(), "x"); }),
              HasSubstr("it is a folder; name a file in it"));
  EXPECT_EQ(FilesIn(folder.path()), 0U);
}

TEST(WriteFileAtomically, WritesDevicesDirectly) {
  EXPECT_EQ(
      ErrorOf([] { WriteText("/dev/full", std::string(100'000, 'x')); }),
      "/dev/full: cannot be written: No space left on device; free some space or choose another disk");
  WriteText("/dev/null", "x");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST(WriteFileAtomically, WritesThroughLinks) {
  const TemporaryFolder folder;
  folder.Write("target", "old and longer");
  fs::create_symlink(folder / "target", folder / "link");
  WriteText(folder / "link", "new");
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(ContentOf(folder / "target"), "new");
}

TEST(AtomicFile, LeavesNothingWithoutCommit) {
  const TemporaryFolder folder;
  {
    AtomicFile file(folder / "file");
    file.stream() << "half";
  }
  EXPECT_EQ(FilesIn(folder.path()), 0U);
}

}  // namespace
}  // namespace ariadne::slam
