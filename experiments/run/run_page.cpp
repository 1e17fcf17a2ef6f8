#include "experiments/run/run_page.h"

#include <fmt/format.h>

#include <algorithm>

namespace ariadne::experiments {
namespace {

namespace fs = std::filesystem;

/// The files of the run by their paths in it, sorted; without what changes or is only for programs.
std::vector<std::string> FilesOf(const RunDirectory& run) {
  std::vector<std::string> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(run.path())) {
    const std::string name = fs::relative(entry.path(), run.path()).generic_string();
    if (entry.is_regular_file() && name != "report.html" && name != "checkpoint.json")
      files.push_back(name);
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<std::string> WithExtension(const std::vector<std::string>& files,
                                       const std::string& extension) {
  std::vector<std::string> found;
  std::copy_if(files.begin(), files.end(), std::back_inserter(found),
               [&](const std::string& file) { return fs::path(file).extension() == extension; });
  return found;
}

/// metrics.json as rows of names and values.
Table MetricsTable(const RunDirectory& run) {
  Table table{{"metric", "value"}, {}};
  const nlohmann::ordered_json metrics = Json::parse(run.ReadText("metrics.json")).flatten();
  for (const auto& [name, value] : metrics.items()) {
    table.rows.push_back({name.substr(1), value.is_string() ? value.get<std::string>() : value.dump()});
  }
  return table;
}

/// Small tables stand open.
PageSection TableSection(const std::string& heading, Table table) {
  constexpr std::size_t kOpenRows = 30;
  const bool folded = table.rows.size() > kOpenRows;
  return {heading, {}, std::move(table), folded};
}

Page MakePage(const RunDirectory& run, const std::string& title) {
  Page page{title, {}, FilesOf(run)};
  const std::vector<std::string> pictures = WithExtension(page.files, ".png");
  if (!pictures.empty()) page.sections.push_back({"Pictures", pictures, {}, false});
  if (std::ranges::find(page.files, "metrics.json") != page.files.end()) {
    page.sections.push_back(TableSection("Results", MetricsTable(run)));
  }
  for (const std::string& file : WithExtension(page.files, ".csv")) {
    page.sections.push_back(TableSection(file, FromCsv(run.ReadText(file))));
  }
  return page;
}

}  // namespace

void FinishRun(const RunDirectory& run, const std::string& title, std::size_t total,
               const std::optional<PageSection>& first) {
  Page page = MakePage(run, title);
  if (first) page.sections.insert(page.sections.begin(), *first);
  run.WriteText("report.html", ToHtml(page));
  run.WriteProgress("finished", total, total);
}

}  // namespace ariadne::experiments
