#include "drivers/hardware/lms200/reply.h"

namespace ariadne::drivers::lms200 {
namespace {

/// The code in front of each reply, and the fields between it and the status byte.
struct Writing {
  WireWriter writer;

  void Head(std::uint8_t code) { writer.Byte(code); }
  Bytes End(std::uint8_t status) {
    writer.Byte(status);
    return writer.Finish();
  }

  Bytes operator()(const PowerOn& reply) {
    Head(kPowerOn);
    writer.Text(reply.type);
    return End(reply.status);
  }
  Bytes operator()(const Notice& reply) {
    Head(reply.code);
    return End(reply.status);
  }
  Bytes operator()(const ModeReply& reply) {
    Head(ReplyTo(Code::kMode));
    writer.Byte(static_cast<std::uint8_t>(reply.answer));
    return End(reply.status);
  }
  Bytes operator()(const ErrorReply& reply) {
    Head(ReplyTo(Code::kErrors));
    for (const ErrorReply::Entry& entry : reply.entries) {
      writer.Byte(entry.type);
      writer.Byte(entry.number);
    }
    return End(reply.status);
  }
  Bytes operator()(const TypeReply& reply) {
    Head(ReplyTo(Code::kType));
    writer.Text(reply.type);
    return End(reply.status);
  }
  Bytes operator()(const VariantReply& reply) {
    Head(ReplyTo(Code::kVariant));
    writer.Byte(reply.ok ? 1 : 0);
    writer.Word(reply.angle);
    writer.Word(reply.resolution);
    return End(reply.status);
  }
  Bytes operator()(const PermanentBaudReply& reply) {
    Head(ReplyTo(Code::kPermanentBaud));
    writer.Byte(reply.ok ? 1 : 0);
    return End(reply.status);
  }
  Bytes operator()(const ConfigReply& reply) {
    Head(ReplyTo(Code::kReadConfig));
    writer.Rest(reply.config.bytes);
    return End(reply.status);
  }
  Bytes operator()(const WrittenReply& reply) {
    Head(ReplyTo(Code::kWriteConfig));
    writer.Byte(reply.ok ? 1 : 0);
    writer.Rest(reply.config.bytes);
    return End(reply.status);
  }
  Bytes operator()(const StatusReply& reply) { return EncodeStatus(reply); }
  Bytes operator()(const MeasuredValues& reply) { return EncodeMeasuredValues(reply); }
};

bool ReadFlag(WireReader& reader) {
  std::uint8_t byte = 0;
  reader.Byte(byte);
  if (byte > 1) Fail("an answer of the LMS-200 is 0 or 1, not {}", byte);
  return byte == 1;
}

ModeReply ReadMode(WireReader& reader) {
  std::uint8_t byte = 0;
  reader.Byte(byte);
  if (byte > 2) Fail("the LMS-200 answers a change of its mode with 0, 1 or 2, not {}", byte);
  return {static_cast<ModeAnswer>(byte)};
}

ErrorReply ReadErrors(WireReader& reader) {
  ErrorReply reply;
  while (reader.size() > 0) {
    ErrorReply::Entry& entry = reply.entries.emplace_back();
    reader.Byte(entry.type);
    reader.Byte(entry.number);
  }
  return reply;
}

VariantReply ReadVariant(WireReader& reader) {
  VariantReply reply;
  reply.ok = ReadFlag(reader);
  reader.Word(reply.angle);
  reader.Word(reply.resolution);
  return reply;
}

template <typename R>
R ReadText(WireReader& reader) {
  R reply;
  reader.Text(reply.type);
  return reply;
}

Config ReadConfig(WireReader& reader) {
  Bytes bytes;
  reader.Rest(bytes);
  return ConfigOf(bytes);
}

WrittenReply ReadWritten(WireReader& reader) {
  WrittenReply reply;
  reply.ok = ReadFlag(reader);
  reply.config = ReadConfig(reader);
  return reply;
}

/// What lies between the code and the status byte.
Reply ReadFields(std::uint8_t code, WireReader& reader) {
  switch (code) {
    case kPowerOn:
      return ReadText<PowerOn>(reader);
    case kResetConfirmed:
    case kUnknownCommand:
      return Notice{code};
    case ReplyTo(Code::kMode):
      return ReadMode(reader);
    case ReplyTo(Code::kErrors):
      return ReadErrors(reader);
    case ReplyTo(Code::kType):
      return ReadText<TypeReply>(reader);
    case ReplyTo(Code::kVariant):
      return ReadVariant(reader);
    case ReplyTo(Code::kPermanentBaud):
      return PermanentBaudReply{ReadFlag(reader)};
    case ReplyTo(Code::kReadConfig):
      return ConfigReply{ReadConfig(reader)};
    case ReplyTo(Code::kWriteConfig):
      return ReadWritten(reader);
    default:
      Fail("the LMS-200 has no reply 0x{:02X}", code);
  }
}

}  // namespace

Bytes EncodeReply(const Reply& reply) { return std::visit(Writing{}, reply); }

Reply DecodeReply(ByteView payload) {
  if (payload.size() < 2) Fail("a reply of the LMS-200 has at least 2 bytes, not {}", payload.size());
  const std::uint8_t code = payload.front();
  if (IsMeasuredValues(code)) return DecodeMeasuredValues(payload);
  if (code == ReplyTo(Code::kStatus)) return DecodeStatus(payload);
  WireReader reader(payload.subspan(1, payload.size() - 2));
  Reply reply = ReadFields(code, reader);
  reader.Finish();
  const std::uint8_t byte = payload.back();
  std::visit([byte](auto& known) { known.status = byte; }, reply);
  return reply;
}

}  // namespace ariadne::drivers::lms200
