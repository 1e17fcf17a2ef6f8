#include <gtest/gtest.h>

#include "tests/planning/polygon/check_union.h"

namespace ariadne::planning {
namespace {

TEST(LabelledUnion, HundredThousandAgreeWithAnIndependentOracle) { CheckRandomUnions(100000, 4); }

}  // namespace
}  // namespace ariadne::planning
