#pragma once

#include <string_view>

namespace ariadne::fuzz {

// The readers, by what they read; see Reader::accepts.

// cloud_readers.cpp
bool AcceptsUosCloud(std::string_view bytes);
bool AcceptsXyz(std::string_view bytes);
bool AcceptsPly(std::string_view bytes);
bool AcceptsPcd(std::string_view bytes);
bool AcceptsKitti(std::string_view bytes);
bool AcceptsCarmen(std::string_view bytes);

// pose_readers.cpp
bool AcceptsUosPose(std::string_view bytes);
bool AcceptsUosFrames(std::string_view bytes);
bool AcceptsTum(std::string_view bytes);
bool AcceptsPoseMatrices(std::string_view bytes);
bool AcceptsPoseList(std::string_view bytes);
bool AcceptsAnyPoses(std::string_view bytes);
bool AcceptsG2o(std::string_view bytes);

// log_readers.cpp
bool AcceptsRobotLog(std::string_view bytes);
bool AcceptsRobotCall(std::string_view bytes);
bool AcceptsLineLog(std::string_view bytes);

// device_readers.cpp
bool AcceptsLms200Stream(std::string_view bytes);
bool AcceptsLms200Requests(std::string_view bytes);
bool AcceptsLms200Payload(std::string_view bytes);
bool AcceptsDynamixel(std::string_view bytes);
bool AcceptsRoboclaw(std::string_view bytes);
bool AcceptsRoboclawReply(std::string_view bytes);
bool AcceptsHobbyServo(std::string_view bytes);
bool AcceptsTelegrams(std::string_view bytes);

}  // namespace ariadne::fuzz
