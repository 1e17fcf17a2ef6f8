#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "drivers/hardware/devices/line_telegrams.h"
#include "slam/base/error.h"

namespace ariadne::drivers {

/// Of a line on which an answer has neither a beginning nor a kind: the request before it tells both.
template <typename Request>
class AnswerReader : public TelegramReader {
 public:
  std::vector<LineTelegram> Take(const LineRecord& record) final {
    std::vector<LineTelegram> telegrams;
    if (record.kind == LineRecord::Kind::kWrite) Ask(record, telegrams);
    if (record.kind == LineRecord::Kind::kRead && !record.bytes.empty()) Answer(record, telegrams);
    return telegrams;
  }

 protected:
  /// What the host wrote in one go.
  virtual std::vector<Request> RequestsIn(ByteView bytes) = 0;
  virtual bool IsAnswered(const Request& request) const = 0;
  virtual std::string TextOf(const Request& request) const = 0;

  /// What is there of the answer says this; none until more of it comes. An Error is the text of a bad one.
  virtual std::optional<LineTelegram> Understand(const Request& request, ByteView answer) const = 0;

 private:
  void Ask(const LineRecord& record, std::vector<LineTelegram>& telegrams) {
    for (const Request& request : RequestsIn(record.bytes)) {
      const char* missing = answer_.empty() ? "no answer" : "half an answer, or a damaged one";
      if (asked_) telegrams.push_back({record.time, false, true, missing, {}});
      asked_ = IsAnswered(request) ? std::optional(request) : std::nullopt;
      answer_.clear();
      telegrams.push_back({record.time, true, false, TextOf(request), {}});
    }
  }

  void Answer(const LineRecord& record, std::vector<LineTelegram>& telegrams) {
    if (!asked_) return;
    answer_.insert(answer_.end(), record.bytes.begin(), record.bytes.end());
    std::optional<LineTelegram> answer;
    try {
      answer = Understand(*asked_, answer_);
    } catch (const Error& error) {
      answer = LineTelegram{0.0, false, true, error.what(), {}};
    }
    if (!answer) return;
    answer->time = record.time;
    telegrams.push_back(*std::move(answer));
    asked_.reset();
  }

  std::optional<Request> asked_;
  Bytes answer_;
};

}  // namespace ariadne::drivers
