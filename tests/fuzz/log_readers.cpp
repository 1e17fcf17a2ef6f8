#include <boost/crc.hpp>
#include <cstdint>
#include <cstring>
#include <istream>
#include <memory>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

#include "drivers/hardware/line_log_stream.h"
#include "drivers/replay/log_frame.h"
#include "drivers/replay/robot_log.h"
#include "tests/fuzz/accepts.h"
#include "tests/fuzz/read_by.h"

namespace ariadne::fuzz {
namespace {

std::string ReadRobotLogBytes(std::istream& in, const std::string& name) {
  drivers::RobotLog log(std::make_unique<std::istringstream>(AllOf(in)), name);
  std::string again = drivers::HeadOfLog();
  for (std::size_t i = 0; i < log.size(); ++i) again += drivers::FramedCall(log.Read(i));
  return again;
}

/// The same file with the checksums that its chunks should have, so that what lies behind them is reached.
drivers::Bytes WithChecksums(const std::string& file) {
  drivers::Bytes mended(file.begin(), file.end());
  for (std::size_t at = 8; at + 8 <= mended.size();) {
    std::uint32_t length = 0;
    std::memcpy(&length, mended.data() + at, sizeof length);
    if (length > mended.size() - at - 8) break;
    boost::crc_32_type crc;
    crc.process_bytes(&length, sizeof length);
    crc.process_bytes(mended.data() + at + 8, length);
    const std::uint32_t checksum = crc.checksum();
    std::memcpy(mended.data() + at + 4, &checksum, sizeof checksum);
    at += 8 + std::size_t{length};
  }
  return mended;
}

/// A file of a log of lines: its records, if it ends with a whole one.
std::vector<drivers::LoggedRecord> RecordsIn(drivers::ByteView file) {
  drivers::LineLogDecoder decoder(file);
  std::vector<drivers::LoggedRecord> records;
  while (std::optional<drivers::LoggedRecord> record = decoder.Next()) records.push_back(*record);
  if (decoder.position() != file.size()) Fail("torn");
  return records;
}

}  // namespace

bool AcceptsRobotLog(std::string_view bytes) {
  return Accepts(bytes, ReadRobotLogBytes, [](std::ostream& out, const std::string& log) { out << log; });
}

/// The payload of a record, which no checksum guards here.
bool AcceptsRobotCall(std::string_view bytes) {
  const auto read = [](std::istream& in, const std::string&) { return drivers::DecodeCall(AllOf(in)); };
  return Accepts(bytes, read, [](std::ostream& out, const drivers::RobotCall& call) {
    out << drivers::EncodeCall(call);
  });
}

bool AcceptsLineLog(std::string_view bytes) {
  const auto read = [](std::istream& in, const std::string&) {
    const std::string all = AllOf(in);
    try {
      RecordsIn(WithChecksums(all));
    } catch (const Error&) {  // the proper answer to damage
    }
    return RecordsIn(ViewOf(all));
  };
  return Accepts(bytes, read, [](std::ostream& out, const std::vector<drivers::LoggedRecord>& records) {
    drivers::LineLogEncoder encoder;
    const auto put = [&](const drivers::Bytes& part) { out << std::string(part.begin(), part.end()); };
    put(encoder.Begin());
    for (const drivers::LoggedRecord& record : records) put(encoder.Add(record));
  });
}

}  // namespace ariadne::fuzz
