#pragma once

#include <string>
#include <vector>

namespace ariadne {

/// Reads "a, b, ..." ; Error that names the text by `where` for anything else, or for no number at all.
std::vector<double> ParseNumbers(const std::string& text, const std::string& where);

}  // namespace ariadne
