#include "drivers/hardware/roboclaw/find_reply.h"

#include <gtest/gtest.h>

namespace ariadne::drivers::roboclaw {
namespace {

constexpr std::uint8_t kAddress = 0x80;
const std::vector<Code> kNone;

Bytes Joined(std::initializer_list<Bytes> parts) {
  Bytes all;
  for (const Bytes& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

const Bytes kCounts = EncodeReply(kAddress, Code::kEncoders, {1, 2, 3, 4, 5, 6, 7, 8});
const Bytes kNegative = EncodeReply(kAddress, Code::kEncoders, {0xFF, 0xFF, 0xFF, 0xFE, 5, 6, 7, 8});
const Bytes kTimeoutReply = EncodeReply(kAddress, Code::kTimeout, {2});
const Bytes kAck{kAcknowledged};

FoundReply Find(Code code, const Bytes& bytes, const std::vector<Code>& late) {
  return FindReply(kAddress, code, bytes, late);
}

TEST(FindReply, TakesAReplyAlone) {
  EXPECT_EQ(Find(Code::kEncoders, kCounts, kNone).data, (Bytes{1, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_TRUE(Find(Code::kSpeeds, kAck, kNone).data);
  EXPECT_FALSE(Find(Code::kSpeeds, {}, kNone).data);
  EXPECT_TRUE(Find(Code::kSpeeds, {}, kNone).can_come);
  EXPECT_FALSE(Find(Code::kSpeeds, {0x12}, kNone).can_come);
}

TEST(FindReply, PassesOverLateOnes) {
  const std::vector<Code> late{Code::kEncoders, Code::kSpeeds, Code::kTimeout};
  EXPECT_TRUE(Find(Code::kSpeeds, Joined({kCounts, kAck}), {Code::kEncoders}).data);
  EXPECT_TRUE(Find(Code::kSpeeds, Joined({kCounts, kTimeoutReply, kAck}), late).data) << "one was lost";
  EXPECT_EQ(Find(Code::kTimeout, Joined({kCounts, kAck, kTimeoutReply}), late).data, Bytes{2});
  EXPECT_TRUE(Find(Code::kSpeeds, Joined({kNegative, kAck}), {Code::kEncoders}).data);
}

/// Nothing is passed over that was not asked for, or in another order.
TEST(FindReply, BelievesNothingElse) {
  EXPECT_FALSE(Find(Code::kSpeeds, Joined({kCounts, kAck}), kNone).data);
  EXPECT_FALSE(Find(Code::kSpeeds, Joined({kCounts, kAck}), {Code::kTimeout}).data);
  EXPECT_FALSE(
      Find(Code::kSpeeds, Joined({kTimeoutReply, kCounts, kAck}), {Code::kEncoders, Code::kTimeout}).data);
  Bytes wrong = kCounts;
  wrong[3] ^= 4U;
  EXPECT_FALSE(Find(Code::kSpeeds, Joined({wrong, kAck}), {Code::kEncoders}).data);
  EXPECT_FALSE(Find(Code::kEncoders, wrong, kNone).data);
}

/// Byte by byte nothing is taken too early but what looks like an acknowledgement.
TEST(FindReply, WaitsForWhatCanCome) {
  const Bytes all = Joined({kCounts, kTimeoutReply});
  for (std::size_t size = 0; size < all.size(); ++size) {
    const FoundReply found =
        Find(Code::kTimeout, Bytes(all.begin(), all.begin() + static_cast<int>(size)), {Code::kEncoders});
    EXPECT_FALSE(found.data) << size;
    EXPECT_TRUE(found.can_come) << size;
  }
}

}  // namespace
}  // namespace ariadne::drivers::roboclaw
