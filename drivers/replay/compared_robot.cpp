#include "drivers/replay/compared_robot.h"

#include <fmt/format.h>

#include <utility>

#include "drivers/replay/call_bytes.h"

namespace ariadne::drivers {

void ComparedRobot::FailDiffering(const RobotCall& recorded, const std::string& now) const {
  throw DepartedFromLog(fmt::format("{}: call {} ({:.3f} s) was recorded as {}; now {}", cursor_.name(),
                                    cursor_.position() + 1, cursor_.last_known().time.value_or(0.0),
                                    Describe(recorded), now));
}

RobotCall ComparedRobot::Answer(RobotCall asked) const {
  if (cursor_.left() == 0) return MadeCall(robot_, std::move(asked));
  const RobotCall recorded = cursor_.Peek();
  if (!AskTheSame(asked, recorded)) FailDiffering(recorded, Describe(asked));
  RobotCall made = MadeCall(robot_, std::move(asked));
  if (EncodeCall(made) != EncodeCall(recorded)) FailDiffering(recorded, "it has another answer");
  cursor_.Pass(recorded);
  return made;
}

void ComparedRobot::Note(std::string_view text) {
  if (cursor_.left() == 0) return;
  const drivers::Note noted{std::string(text)};
  const RobotCall recorded = cursor_.Peek();
  const auto* note = std::get_if<drivers::Note>(&recorded);
  if (note == nullptr || note->text != noted.text) FailDiffering(recorded, Describe(noted));
  cursor_.PassNote();
}

}  // namespace ariadne::drivers
