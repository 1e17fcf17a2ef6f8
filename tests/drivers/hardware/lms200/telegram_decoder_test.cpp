#include "drivers/hardware/lms200/telegram_decoder.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/drivers/hardware/lms200/samples.h"

namespace ariadne::drivers::lms200 {
namespace {

using Kind = Received::Kind;

std::vector<Received> TakeAll(TelegramDecoder& decoder) {
  std::vector<Received> all;
  while (std::optional<Received> next = decoder.Next()) all.push_back(*next);
  return all;
}

std::vector<Received> Decode(ByteView bytes) {
  TelegramDecoder decoder(Sender::kDevice);
  decoder.Push(bytes);
  return TakeAll(decoder);
}

std::vector<Telegram> TelegramsOf(const std::vector<Received>& all) {
  std::vector<Telegram> telegrams;
  for (const Received& received : all) {
    if (received.kind == Kind::kTelegram) telegrams.push_back(received.telegram);
  }
  return telegrams;
}

void Append(Bytes& bytes, const Bytes& more) { bytes.insert(bytes.end(), more.begin(), more.end()); }

/// Telegrams, ACKs, NAKs, garbage that likes to begin like a telegram, and damaged telegrams.
Bytes AnyStream(RandomStream& stream) {
  Bytes bytes;
  for (int i = 0; i < 12; ++i) {
    Bytes frame = FrameOf(AnyReply(stream, Draw(stream, 0, kReplyKinds - 1)));
    switch (Draw(stream, 0, 6)) {
      case 0:
        Append(bytes, {kAckByte});
        break;
      case 1:
        Append(bytes, {kNakByte});
        break;
      case 2:
        Append(bytes, DrawBytes(stream, Draw(stream, 0, 20)));
        break;
      case 3:
        Append(bytes,
               {kStxByte, kFromDevice, DrawByte(stream), static_cast<std::uint8_t>(Draw(stream, 0, 3))});
        break;
      case 4:
        frame[Draw(stream, 0, static_cast<std::uint32_t>(frame.size()) - 1)] ^= DrawByte(stream);
        break;
      default:
        break;
    }
    Append(bytes, frame);
  }
  return bytes;
}

TEST(Lms200TelegramDecoder, FindsTheSameHoweverTheStreamIsCut) {
  RandomStream stream = NamedStream(1, "cuts");
  for (int round = 0; round < 60; ++round) {
    const Bytes bytes = AnyStream(stream);
    const std::vector<Received> whole = Decode(bytes);
    for (const std::uint32_t longest : {1U, 7U, 300U}) {
      TelegramDecoder decoder(Sender::kDevice);
      std::vector<Received> pieces;
      for (std::size_t at = 0; at < bytes.size();) {
        const std::size_t size = std::min<std::size_t>(Draw(stream, 1, longest), bytes.size() - at);
        decoder.Push(ByteView(bytes).subspan(at, size));
        const std::vector<Received> found = TakeAll(decoder);
        pieces.insert(pieces.end(), found.begin(), found.end());
        at += size;
      }
      ASSERT_EQ(pieces, whole) << "seed 1, round " << round;
    }
  }
}

TEST(Lms200TelegramDecoder, FindsEachTelegramBetweenGarbage) {
  RandomStream stream = NamedStream(2, "garbage");
  for (int round = 0; round < 100; ++round) {
    Bytes bytes;
    std::vector<Telegram> sent;
    for (int i = 0; i < 10; ++i) {
      Bytes garbage = DrawBytes(stream, Draw(stream, 0, 30));
      std::replace(garbage.begin(), garbage.end(), kStxByte,
                   std::uint8_t{0});  // a false STX may hide what follows
      Append(bytes, garbage);
      sent.push_back({kFromDevice, EncodeReply(AnyReply(stream, Draw(stream, 0, kReplyKinds - 1)))});
      Append(bytes, EncodeTelegram(sent.back()));
    }
    EXPECT_EQ(TelegramsOf(Decode(bytes)), sent) << "round " << round;
  }
}

/// A wrong length swallows what comes next, but only until enough has come to find it wrong.
TEST(Lms200TelegramDecoder, FindsWhatAFalseTelegramHides) {
  const Bytes good = FrameOf(Reply(TypeReply{"LMS200"}));
  Bytes bytes = FromHex("02 80 20 00 B0");
  for (int i = 0; i < 4; ++i) Append(bytes, good);
  const std::vector<Received> all = Decode(bytes);
  EXPECT_EQ(all.front().kind, Kind::kBadCrc);
  EXPECT_EQ(TelegramsOf(all).size(), 4U);
}

TEST(Lms200TelegramDecoder, FindsItWithoutMoreBytesWhenToldThatNoneCome) {
  TelegramDecoder decoder(Sender::kDevice);
  decoder.Push(FromHex("02 80 20 03 B0"));
  decoder.Push(FrameOf(Reply(TypeReply{"LMS200"})));
  EXPECT_FALSE(decoder.Next());
  EXPECT_TRUE(decoder.IsWaiting());
  decoder.GiveUp();
  const std::optional<Received> found = decoder.Next();
  ASSERT_TRUE(found);
  EXPECT_EQ(found->kind, Kind::kTelegram);
  EXPECT_EQ(decoder.garbage(), 5U);
}

TEST(Lms200TelegramDecoder, TellsAnAcknowledgementFromOneWithinATelegram) {
  Bytes wrong = FrameOf(Reply(ErrorReply{{{kAckByte, kNakByte}, {kAckByte, kNakByte}}}));
  wrong.back() ^= 1;
  Bytes bytes = {kAckByte};
  Append(bytes, wrong);
  Append(bytes, {kNakByte});
  std::vector<Kind> kinds;
  for (const Received& received : Decode(bytes)) kinds.push_back(received.kind);
  EXPECT_EQ(kinds, (std::vector<Kind>{Kind::kAck, Kind::kBadCrc, Kind::kNak}));
}

TEST(Lms200TelegramDecoder, TakesNeitherSideForTheOther) {
  const Bytes command = FrameOf(CommandOf(Code::kStatus));
  const Bytes reply = FrameOf(Reply(ModeReply{}));
  TelegramDecoder of_host(Sender::kHost);
  of_host.Push(reply);
  EXPECT_TRUE(TelegramsOf(TakeAll(of_host)).empty());
  EXPECT_TRUE(TelegramsOf(Decode(command)).empty());
}

TEST(Lms200TelegramDecoder, SaysWhereEachThingEnds) {
  const Bytes frame = FrameOf(Reply(ModeReply{}));
  Bytes bytes = {0xFF, kAckByte};
  Append(bytes, frame);
  Append(bytes, frame);
  const std::vector<Received> all = Decode(bytes);
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0].end, 2U);
  EXPECT_EQ(all[1].end, 2U + frame.size());
  EXPECT_EQ(all[2].end, 2U + 2 * frame.size());
}

}  // namespace
}  // namespace ariadne::drivers::lms200
