#include "experiments/mission/area_left.h"

#include <gtest/gtest.h>

namespace ariadne::experiments {
namespace {

/// 20 m x 2 m; a corner's label is that of the edge that begins there.
planning::LabelledPolygon Corridor(bool left_seen, bool right_seen, double slit) {
  planning::LabelledPolygon corridor;
  corridor.outer = {{{0.0, 0.0}, true},        {{10.0, 0.0}, false}, {{10.0 + slit, 0.0}, true},
                    {{20.0, 0.0}, right_seen}, {{20.0, 2.0}, true},  {{0.0, 2.0}, left_seen}};
  return corridor;
}

TEST(AreaLeft, CountsNeighbourhoodsOfOpenings) {
  const auto views = [](const planning::LabelledPolygon& area) { return ViewsLeft({&area, 1}, 0.3); };
  EXPECT_EQ(views(Corridor(true, true, 0.2)), 0);  // too small an opening
  EXPECT_EQ(views(Corridor(true, true, 0.4)), 1);
  EXPECT_EQ(views(Corridor(false, true, 0.2)), 1);
  EXPECT_EQ(views(Corridor(false, false, 0.4)), 3);
  EXPECT_EQ(ViewsLeft({}, 0.3), 0);
}

TEST(AreaLeft, CountsOpeningsNearEachOtherOnce) {
  planning::LabelledPolygon room;
  room.outer = {{{0.0, 0.0}, true},  {{1.0, 0.0}, false}, {{2.0, 0.0}, true},
                {{3.0, 0.0}, false}, {{4.0, 0.0}, true},  {{4.0, 3.0}, true}};
  EXPECT_EQ(ViewsLeft({&room, 1}, 0.3), 1);
}

TEST(AreaLeft, MeasuresWhatIsUnseenAndFree) {
  const planning::LabelledPolygon corridor = Corridor(false, true, 0.5);
  EXPECT_DOUBLE_EQ(UnseenLength({&corridor, 1}), 2.0 + 0.5);
  EXPECT_DOUBLE_EQ(FreeArea({&corridor, 1}), 40.0);
}

}  // namespace
}  // namespace ariadne::experiments
