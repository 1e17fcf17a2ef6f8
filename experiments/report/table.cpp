#include "experiments/report/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string_view>

namespace ariadne::experiments {
namespace {

std::string CsvCell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

/// The cells as `write` gives them, with a separator between.
std::string Joined(const std::vector<std::string>& cells, const char* separator,
                   std::string (*write)(const std::string&)) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i > 0) line += separator;
    line += write(cells[i]);
  }
  return line;
}

std::string CsvLine(const std::vector<std::string>& cells) { return Joined(cells, ",", CsvCell) + "\n"; }

bool LooksNumeric(const std::string& text) {
  double value = 0.0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && stop != text.data();
}

/// Terminal columns of UTF-8 text: bytes that do not continue a character.
std::size_t DisplayWidth(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string LatexCell(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (std::string_view("%_&#${}").find(c) != std::string_view::npos) escaped += '\\';
    if (c == '\\') {
      escaped += "\\textbackslash{}";
    } else if (c == '~' || c == '^') {
      escaped += fmt::format("\\{}{{}}", c);
    } else {
      escaped += c;
    }
  }
  return escaped;
}

std::string LatexLine(const std::vector<std::string>& cells) {
  return Joined(cells, " & ", LatexCell) + " \\\\\n";
}

}  // namespace

std::string ToCsv(const Table& table) {
  std::string text = CsvLine(table.columns);
  for (const auto& row : table.rows) text += CsvLine(row);
  return text;
}

Table FromCsv(const std::string& text) {
  std::vector<std::vector<std::string>> rows(1, std::vector<std::string>(1));
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    std::string& cell = rows.back().back();
    if (text[i] == '"') {
      if (quoted && i + 1 < text.size() && text[i + 1] == '"')
        cell += text[++i];  // "" is a quote
      else
        quoted = !quoted;
    } else if (text[i] == ',' && !quoted) {
      rows.back().emplace_back();
    } else if (text[i] == '\n' && !quoted) {
      rows.emplace_back(1);
    } else {
      cell += text[i];
    }
  }
  rows.pop_back();  // after the last line's end
  Table table{rows.front(), {rows.begin() + 1, rows.end()}};
  return table;
}

std::string ToText(const Table& table) {
  std::vector<std::size_t> widths;
  for (const std::string& column : table.columns) widths.push_back(DisplayWidth(column));
  for (const auto& row : table.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], DisplayWidth(row[i]));
  }
  const auto line = [&](const std::vector<std::string>& cells) {
    std::string text;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::string padding(widths[i] - DisplayWidth(cells[i]), ' ');
      const bool number = !table.rows.empty() && LooksNumeric(table.rows.front()[i]);
      text += (i > 0 ? "  " : "") + (number ? padding + cells[i] : cells[i] + padding);
    }
    text.erase(text.find_last_not_of(' ') + 1);
    return text + "\n";
  };
  std::string text = line(table.columns);
  for (const auto& row : table.rows) text += line(row);
  return text;
}

std::string ToLatex(const Table& table) {
  std::string columns;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    columns += !table.rows.empty() && LooksNumeric(table.rows.front()[i]) ? 'r' : 'l';
  }
  std::string text =
      "\\begin{tabular}{" + columns + "}\n\\toprule\n" + LatexLine(table.columns) + "\\midrule\n";
  for (const auto& row : table.rows) text += LatexLine(row);
  return text + "\\bottomrule\n\\end{tabular}\n";
}

std::string Exact(double value) { return fmt::format("{}", value); }

std::string Percent(double share) { return fmt::format("{:.1f}", 100.0 * share); }

}  // namespace ariadne::experiments
