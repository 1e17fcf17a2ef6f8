#include "drivers/hardware/memory_line.h"

#include <gtest/gtest.h>

#include "slam/base/error.h"

namespace ariadne::drivers {
namespace {

TEST(MemoryLine, CarriesBytesBothWays) {
  MemoryLine line;
  line.end(0).Write(Bytes{1, 2, 3});
  line.end(0).Write(Bytes{4});
  line.end(1).Write(Bytes{9});
  EXPECT_EQ(line.end(1).Read(10.0), (Bytes{1, 2, 3, 4}));
  EXPECT_EQ(line.end(0).Read(10.0), (Bytes{9}));
  EXPECT_EQ(line.end(0).Now(), 0.0);  // nobody had to wait
}

TEST(MemoryLine, LetsTimePassWhileAnEndWaits) {
  MemoryLine line;
  EXPECT_TRUE(line.end(0).Read(1.5).empty());
  EXPECT_EQ(line.end(1).Now(), 1.5);
  EXPECT_TRUE(line.end(0).Read(1.0).empty());  // a deadline in the past does not turn time back
  EXPECT_EQ(line.end(0).Now(), 1.5);
  line.end(1).Write(Bytes{7});
  DiscardUntil(line.end(0), 2.0);
  EXPECT_EQ(line.end(0).Now(), 2.0);
  EXPECT_TRUE(line.end(0).Read(0.0).empty());
}

TEST(MemoryLine, GarblesWhatIsSentAtAnotherRate) {
  MemoryLine line;
  line.end(0).SetBaud(38400);
  line.end(0).Write(Bytes{1, 2});
  const Bytes noise = line.end(1).Read(1.0);
  EXPECT_EQ(noise.size(), 2U);
  EXPECT_NE(noise, (Bytes{1, 2}));
  line.end(1).SetBaud(38400);
  line.end(0).Write(Bytes{1, 2});
  EXPECT_EQ(line.end(1).Read(1.0), (Bytes{1, 2}));
}

TEST(MemoryLine, FailsWhenItIsCut) {
  MemoryLine line;
  line.Cut();
  EXPECT_THROW(line.end(0).Read(1.0), Error);
  EXPECT_THROW(line.end(1).Write(Bytes{1}), Error);
}

}  // namespace
}  // namespace ariadne::drivers
