#include "slam/base/error.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace ariadne {
namespace {

std::string MessageOfFail() {
  try {
    Fail("{}:{}: expected a number, not \"{}\"", "scan000.3d", 17, "abc");
  } catch (const Error& error) {
    return error.what();
  }
}

TEST(Fail, ThrowsTheFormattedSentence) {
  EXPECT_EQ(MessageOfFail(), "scan000.3d:17: expected a number, not \"abc\"");
}

TEST(Fail, KeepsBracesOfArguments) {
  EXPECT_THROW(
      try { Fail("key {}", "{unknown}"); } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "key {unknown}");
        throw;
      },
      Error);
}

TEST(Error, IsCaughtAsAStandardException) { EXPECT_THROW(Fail("no points"), std::runtime_error); }

TEST(Error, TakesASentenceThatIsNotAFormat) {
  EXPECT_STREQ(Error("100 % {of} the points are NaN").what(), "100 % {of} the points are NaN");
}

}  // namespace
}  // namespace ariadne
