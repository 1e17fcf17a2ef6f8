#include "experiments/report/page.h"

#include <fmt/format.h>

namespace ariadne::experiments {
namespace {

constexpr const char* kStyle = R"(<style>
body { font: 15px/1.45 system-ui, sans-serif; max-width: 72rem; margin: 2rem auto; padding: 0 1rem; color: #222 }
h1 { font-size: 1.5rem } h2 { font-size: 1.15rem; margin-top: 2rem }
img { max-width: 100%; border: 1px solid #ddd; margin: 0.3rem 0 }
table { border-collapse: collapse; font-size: 0.85rem; font-variant-numeric: tabular-nums }
th, td { padding: 0.15rem 0.7rem; text-align: right; border-bottom: 1px solid #eee }
th { position: sticky; top: 0; background: #fff; border-bottom: 2px solid #888 }
td:first-child, th:first-child { text-align: left }
div.table { overflow: auto; max-height: 32rem }
summary { cursor: pointer; color: #555 }
@media (prefers-color-scheme: dark) {
  :root { color-scheme: dark } body { background: #101214; color: #ddd }
  th { background: #101214 } th, td { border-color: #333 } summary { color: #aaa } img { border-color: #333 }
}
</style>
)";

std::string Escaped(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

std::string Row(const std::vector<std::string>& cells, const char* tag) {
  std::string row = "<tr>";
  for (const std::string& cell : cells) row += fmt::format("<{0}>{1}</{0}>", tag, Escaped(cell));
  return row + "</tr>\n";
}

std::string TableHtml(const Table& table, bool folded) {
  std::string html = "<div class=\"table\"><table>\n" + Row(table.columns, "th");
  for (const std::vector<std::string>& row : table.rows) html += Row(row, "td");
  html += "</table></div>\n";
  if (!folded) return html;
  return fmt::format("<details><summary>{} rows</summary>\n{}</details>\n", table.rows.size(), html);
}

std::string SectionHtml(const PageSection& section) {
  std::string html = fmt::format("<h2>{}</h2>\n", Escaped(section.heading));
  for (const std::string& picture : section.pictures) {
    html += fmt::format("<a href=\"{0}\"><img src=\"{0}\" alt=\"{0}\"></a>\n", Escaped(picture));
  }
  html += section.html;
  if (!section.table.columns.empty()) html += TableHtml(section.table, section.folded);
  return html;
}

}  // namespace

std::string ToHtml(const Page& page) {
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<meta "
      "charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width, "
      "initial-scale=1\">\n<title>{0}</title>\n{1}<h1>{0}</h1>\n",
      Escaped(page.title), kStyle);
  for (const PageSection& section : page.sections) html += SectionHtml(section);
  if (!page.files.empty()) html += "<h2>Files</h2>\n<ul>\n";
  for (const std::string& file : page.files) {
    html += fmt::format("<li><a href=\"{0}\">{0}</a></li>\n", Escaped(file));
  }
  return html + (page.files.empty() ? "" : "</ul>\n") + "</html>\n";
}

}  // namespace ariadne::experiments
