#include "drivers/hardware/hobby_servo/maestro.h"

#include <gtest/gtest.h>

#include "slam/base/random.h"

namespace ariadne::drivers::hobby_servo {
namespace {

std::vector<Request> Decoded(const Bytes& bytes, std::size_t piece, std::uint64_t* bad = nullptr) {
  RequestDecoder decoder;
  std::vector<Request> requests;
  for (std::size_t at = 0; at < bytes.size(); at += piece) {
    decoder.Push(ByteView(bytes).subspan(at, std::min(piece, bytes.size() - at)));
    while (const std::optional<Request> request = decoder.Next()) requests.push_back(*request);
  }
  if (bad != nullptr) *bad = decoder.bad();
  return requests;
}

/// The example of Pololu's guide: channel 2 to 1500 us.
TEST(Maestro, WritesTheExampleOfItsGuide) {
  EXPECT_EQ(EncodeRequest({Code::kSetTarget, 2, 6000}), (Bytes{0x84, 0x02, 0x70, 0x2E}));
  EXPECT_EQ(EncodeRequest({Code::kPosition, 5, 0}), (Bytes{0x90, 0x05}));
  EXPECT_EQ(EncodeRequest({Code::kErrors, 0, 0}), (Bytes{0xA1}));
  EXPECT_EQ(NumberOf(Bytes{0x70, 0x17}), 6000);
  EXPECT_THROW(EncodeRequest({Code::kSetTarget, 24, 0}), Error);
  EXPECT_THROW(EncodeRequest({Code::kSetTarget, 0, 1 << 14}), Error);
}

TEST(Maestro, ReadsWhatIsWrittenHoweverItIsCut) {
  RandomStream stream = NamedStream(1, "maestro");
  constexpr Code kCodes[] = {Code::kSetTarget, Code::kSetSpeed, Code::kSetAcceleration,
                             Code::kPosition,  Code::kErrors,   Code::kDetectBaud};
  Bytes bytes;
  std::vector<Request> sent;
  for (int i = 0; i < 200; ++i) {
    Request request{kCodes[stream() % 6], 0, 0};
    if (DataSize(request.code) > 0) request.channel = static_cast<std::uint8_t>(stream() % 24);
    if (DataSize(request.code) == 3) request.number = static_cast<int>(stream() % (1 << 14));
    const Bytes encoded = EncodeRequest(request);
    bytes.insert(bytes.end(), encoded.begin(), encoded.end());
    sent.push_back(request);
  }
  for (const std::size_t piece : {1U, 3U, 7U, 10000U}) EXPECT_EQ(Decoded(bytes, piece), sent);
}

/// Half a command is given up at the beginning of the next one.
TEST(Maestro, FindsTheNextCommandAfterDamage) {
  std::uint64_t bad = 0;
  EXPECT_EQ(Decoded({0x84, 0x02, 0x70, 0xA1}, 1, &bad), (std::vector<Request>{{Code::kErrors, 0, 0}}));
  EXPECT_GT(bad, 0U);
  EXPECT_EQ(Decoded({0x11, 0xFF, 0x90, 0x05}, 2), (std::vector<Request>{{Code::kPosition, 5, 0}}));
  EXPECT_TRUE(Decoded({0x90, 0x30}, 1).empty());  // there is no channel 48
}

}  // namespace
}  // namespace ariadne::drivers::hobby_servo
