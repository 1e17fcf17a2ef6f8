#include "experiments/config/option_entries.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/slam/io/support.h"

namespace ariadne::experiments {
namespace {

using slam::testing_support::ErrorOf;
using slam::testing_support::TemporaryFolder;
using testing::AllOf;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;

auto Entry(const std::string& key, const std::string& value, const std::string& where) {
  return AllOf(Field(&OptionEntry::key, key), Field(&OptionEntry::value, value),
               Field(&OptionEntry::where, where));
}

OptionEntries ReadEntries(const std::string& text) { return OptionEntries::FromText(text, "a.yaml"); }

std::string ErrorOfEntries(const std::string& text) {
  return ErrorOf([&] { ReadEntries(text); });
}

TEST(OptionEntries, KnowTheirKeysValuesAndLines) {
  EXPECT_THAT(
      ReadEntries("# a comment\nexperiment: register\nicp:\n  trim: 0.5  # why\n\n  inner:\n    x: 'a b'\n")
          .entries(),
      ElementsAre(Entry("experiment", "register", "a.yaml:2"), Entry("icp.trim", "0.5", "a.yaml:4"),
                  Entry("icp.inner.x", "a b", "a.yaml:7")));
}

TEST(OptionEntries, MayBeNone) {
  for (const char* text : {"", "\n\n", "# only a comment\n", "---\n", "{}"}) {
    EXPECT_THAT(ReadEntries(text).entries(), IsEmpty()) << text;
  }
}

TEST(OptionEntries, AreTakenOnce) {
  OptionEntries entries = ReadEntries("a: 1\nb: 2\n");
  EXPECT_EQ(entries.Take("b")->value, "2");
  EXPECT_FALSE(entries.Take("b").has_value());
  EXPECT_THAT(entries.entries(), ElementsAre(Entry("a", "1", "a.yaml:1")));
}

TEST(OptionEntries, AreReplacedByTheCommandLine) {
  OptionEntries entries = ReadEntries("a: 1\nb: 2\n");
  entries.Set("a=3");
  entries.Set("c=x=y");
  entries.Set("c=");
  EXPECT_THAT(entries.entries(), ElementsAre(Entry("b", "2", "a.yaml:2"), Entry("a", "3", "--set a=3"),
                                             Entry("c", "", "--set c=")));
}

TEST(OptionEntries, RefuseAnAssignmentWithoutKeyOrValue) {
  for (const char* text : {"icp.trim", "=0.5", ""}) {
    EXPECT_THAT(ErrorOf([&] { OptionEntries().Set(text); }), HasSubstr("expected key=value")) << text;
  }
}

TEST(OptionEntries, RefuseARepeatedKeyAndNameBothLines) {
  EXPECT_EQ(ErrorOfEntries("a: 1\nb: 2\na: 3\n"),
            "a.yaml:3: the key a is repeated; it stands already at a.yaml:1");
  EXPECT_EQ(ErrorOfEntries("s:\n  x: 1\n  x: 1\n"),
            "a.yaml:3: the key s.x is repeated; it stands already at a.yaml:2");
  EXPECT_EQ(ErrorOfEntries("s:\n  x: 1\nt: 2\ns:\n  y: 1\n"),
            "a.yaml:4: the key s is repeated; it stands already at a.yaml:2")
      << "a section may not be opened twice";
  EXPECT_EQ(ErrorOfEntries("s.x: 1\ns:\n  x: 2\n"),
            "a.yaml:2: the key s is repeated; it stands already at a.yaml:1");
}

TEST(OptionEntries, DoNotTakeASimilarKeyForARepeatedOne) {
  EXPECT_EQ(ReadEntries("scan: 1\nscans: 2\nscan_: 3\ns:\n  scan: 4\n").entries().size(), 4U);
}

TEST(OptionEntries, RefuseWhatIsNoScalar) {
  EXPECT_EQ(ErrorOfEntries("a: 1\nb: [1, 2]\n"), "a.yaml:2: b needs a value, not a list");
  EXPECT_EQ(ErrorOfEntries("s:\n  b:\n"), "a.yaml:2: s.b needs a value");
  EXPECT_EQ(ErrorOfEntries("\n- a\n- b\n"), "a.yaml:2: a config is a map of keys to values");
  EXPECT_EQ(ErrorOfEntries("only words\n"), "a.yaml:1: a config is a map of keys to values");
}

TEST(OptionEntries, RefuseTextThatIsNotYaml) {
  for (const char* text :
       {"a: 1\nb: [1\n", "a: 1\n  b: : 2\n", "a: 1\n\tb: 2\n", "a: 1\nb: {x\n", "a: 1\n*no: 2\n"}) {
    EXPECT_THAT(ErrorOfEntries(text), testing::ContainsRegex("^a\\.yaml:[23]: not valid YAML: .+")) << text;
  }
}

TEST(OptionEntries, RefuseASecondDocument) {
  EXPECT_EQ(ErrorOfEntries("a: 1\n---\nb: 2\n"),
            "a.yaml:3: a config is one YAML document; the file holds 2");
}

TEST(OptionEntries, SurviveAnAliasWithinItself) {
  EXPECT_THAT(ErrorOfEntries("s: &s\n  x: 1\n  again: *s\n"),
              AllOf(HasSubstr("a.yaml:"), HasSubstr("is nested too deeply")));
}

TEST(OptionEntries, AreReadFromAFile) {
  const TemporaryFolder folder;
  const std::string path = folder.Write("my.yaml", "a: 1\n").string();
  EXPECT_THAT(OptionEntries::FromFile(path).entries(), ElementsAre(Entry("a", "1", path + ":1")));
  EXPECT_THAT(ErrorOf([&] { OptionEntries::FromFile((folder / "other.yaml").string()); }),
              AllOf(HasSubstr("other.yaml"), HasSubstr("cannot open the config")));
  EXPECT_THAT(ErrorOf([&] { OptionEntries::FromFile(folder.path().string()); }),
              HasSubstr("is a folder, not a config"));
}

}  // namespace
}  // namespace ariadne::experiments
