#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "drivers/replay/robot_call.h"

namespace ariadne::drivers {

/// A call as the bytes of its record, see robot_log.h. Every number keeps its bits.
std::string EncodeCall(const RobotCall& call);

/// The call of a record. Bytes that EncodeCall cannot have written are an Error.
RobotCall DecodeCall(std::string_view bytes);

/// The kind of a record, without a look at the rest; nothing where there is no such kind.
std::optional<CallKind> KindOfBytes(std::string_view bytes);

}  // namespace ariadne::drivers
