#pragma once

#include <string>
#include <vector>

namespace ariadne::experiments {

/// Rows of text under named columns: the one form in which results leave a run, as CSV for programs, as
/// aligned text for people, and as LaTeX for the paper.
struct Table {
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;  // each as long as columns
};

std::string ToCsv(const Table& table);

/// The table that ToCsv() has written.
Table FromCsv(const std::string& text);

/// Aligned columns, numbers to the right.
std::string ToText(const Table& table);

/// A booktabs tabular.
std::string ToLatex(const Table& table);

/// The shortest text that reads back to the same number: what machine-readable results hold.
std::string Exact(double value);

/// A share in percent, for people: "12.3".
std::string Percent(double share);

}  // namespace ariadne::experiments
