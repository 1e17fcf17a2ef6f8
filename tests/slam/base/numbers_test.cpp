#include "slam/base/numbers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_of.h"

namespace ariadne {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(ParseNumbers, ReadsListsOfOneAndMore) {
  EXPECT_THAT(ParseNumbers("0.5, 1,2e1 , -4", "levels"), ElementsAre(0.5, 1.0, 20.0, -4.0));
  EXPECT_THAT(ParseNumbers("7", "levels"), ElementsAre(7.0));
}

TEST(ParseNumbers, SaysWhatIsNoNumber) {
  for (const char* text : {"1, two", "1,,2", "1 2", "1, inf", "nan"}) {
    EXPECT_THAT(ErrorOf([&] { ParseNumbers(text, "levels"); }), HasSubstr("levels: '")) << text;
  }
  EXPECT_THAT(ErrorOf([] { ParseNumbers("", "levels"); }), HasSubstr("at least one number"));
}

}  // namespace
}  // namespace ariadne
