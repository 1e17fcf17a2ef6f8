#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "slam/base/error.h"

namespace ariadne {

/// The sentence of the Error that an action throws; the test fails where it throws none.
inline std::string ErrorOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  ADD_FAILURE() << "no Error was thrown";
  return "";
}

}  // namespace ariadne
