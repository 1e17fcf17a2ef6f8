#pragma once

#include <algorithm>
#include <optional>

#include "drivers/replay/robot_log.h"

namespace ariadne::drivers {

/// What a log says last about where and when the robot was.
struct LastKnown {
  std::optional<double> time;  // [s]
  std::optional<slam::Odometry> odometry;
};

/// Goes through a log, record by record.
class LogCursor {
 public:
  /// Keeps a reference.
  explicit LogCursor(RobotLog& log) : log_(&log) {}

  std::size_t position() const { return position_; }
  std::size_t left() const { return log_->size() - position_; }
  bool AtNote() const { return left() > 0 && log_->KindAt(position_) == CallKind::kNote; }
  const LastKnown& last_known() const { return last_known_; }
  const std::string& name() const { return log_->name(); }

  RobotCall Peek() { return log_->Read(position_); }
  /// Goes on behind `call`, which Peek has returned.
  void Pass(const RobotCall& call);
  void PassNote() { ++position_; }
  void PassNotes();

 private:
  void NoteTime(double time);

  RobotLog* log_;
  std::size_t position_ = 0;
  LastKnown last_known_;
};

}  // namespace ariadne::drivers
