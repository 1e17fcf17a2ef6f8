#include "slam/base/numbers.h"

#include <cmath>
#include <sstream>

#include "slam/base/error.h"

namespace ariadne {

std::vector<double> ParseNumbers(const std::string& text, const std::string& where) {
  std::vector<double> numbers;
  std::istringstream items(text);
  for (std::string item; std::getline(items, item, ',');) {
    std::istringstream in(item);
    double number = 0.0;
    std::string rest;
    if (!(in >> number) || in >> rest || !std::isfinite(number)) {
      Fail("{}: '{}' is not a number; write a, b, ...", where, item);
    }
    numbers.push_back(number);
  }
  if (numbers.empty()) Fail("{}: needs at least one number: a, b, ...", where);
  return numbers;
}

}  // namespace ariadne
