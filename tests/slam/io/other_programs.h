#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <string>
#include <vector>

/// Programs of others, which read what this project writes.
namespace ariadne::slam::testing_support {

inline bool IsInstalled(const std::string& program) {
  return std::system(("command -v " + program + " >/dev/null 2>&1").c_str()) == 0;
}

/// What a command writes; the test fails where it does not end well.
inline std::string OutputOf(const std::string& command) {
  std::string output;
  FILE* const pipe = popen((command + " 2>&1").c_str(), "r");
  std::array<char, 4096> piece{};
  while (std::size_t read = fread(piece.data(), 1, piece.size(), pipe)) output.append(piece.data(), read);
  EXPECT_EQ(pclose(pipe), 0) << command << "\n" << output;
  return output;
}

/// The numbers that a text has after a label.
inline std::vector<double> NumbersAfter(const std::string& text, const std::string& label) {
  std::vector<double> numbers;
  const std::size_t found = text.find(label);
  if (found == std::string::npos) return numbers;
  const std::size_t begin = found + label.size();
  const std::string rest = text.substr(begin, text.find('\n', begin) - begin);
  static const std::regex number(R"([-+]?[0-9]+(\.[0-9]+)?)");
  for (std::sregex_iterator i(rest.begin(), rest.end(), number), last; i != last; ++i) {
    numbers.push_back(std::stod(i->str()));
  }
  return numbers;
}

/// What assimp's program finds in a file.
struct AssimpInfo {
  std::vector<double> vertices, faces, low, high;
};

inline AssimpInfo InfoByAssimp(const std::filesystem::path& path) {
  const std::string text = OutputOf("assimp info " + path.string());
  return {NumbersAfter(text, "\nVertices:"), NumbersAfter(text, "\nFaces:"),
          NumbersAfter(text, "Minimum point"), NumbersAfter(text, "Maximum point")};
}

}  // namespace ariadne::slam::testing_support

/// Skips the test where the program is not there.
#define ARIADNE_REQUIRE_PROGRAM(program)                                                      \
  if (!ariadne::slam::testing_support::IsInstalled(program)) {                                \
    GTEST_SKIP() << (program) << " is not installed; see [test] in third_party/packages.txt"; \
  }
